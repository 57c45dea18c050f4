// SPDX-License-Identifier: Apache-2.0
#include "identification/refinement.hpp"

#include <algorithm>
#include <cmath>

#include "identification/shape_search.hpp"

namespace torquewright::identification {
namespace {

/// Of the squared error with the noise in it, against the grid's: neighbours on the grid together
/// follow noise a little better than the one law that stands for them.
constexpr double kMostWorse = 1.01;

/// A column's difference between two shapes, over the step: its derivative.
Column slope_column(const std::shared_ptr<Balance>& balance, const std::string& effect,
                    std::vector<double> shape, std::size_t parameter, double relative_step,
                    double scale) {
  const double step = relative_step * shape[parameter];
  std::vector<double> below = shape, above = shape;
  below[parameter] -= step;
  above[parameter] += step;
  const Column low = shaped_column(balance, effect, below),
               high = shaped_column(balance, effect, above);
  const double factor = scale / (2.0 * step);
  return {"slope", [low, high, factor](const Signals& signals, std::vector<double>& out) {
            std::vector<double> other(out.size());
            high.fill(signals, out);
            low.fill(signals, other);
            for (std::size_t i = 0; i < out.size(); ++i) out[i] = factor * (out[i] - other[i]);
          }};
}

/// The dictionary of the model at a shape: its members' variants in their order.
void fill_dictionary(const ShapeSearch& search, const Equation& equation, const Fit& model,
                     std::span<const double> shape, RefinedModel& out) {
  out.dictionary.columns = equation.dictionary.columns;
  out.dictionary.warmed = equation.dictionary.warmed;
  out.dictionary.nominal_drag_warmed = equation.dictionary.nominal_drag_warmed;
  std::vector<Column> whole;
  for (const std::size_t index : model.members) {
    out.dictionary.variants.push_back(equation.dictionary.variants[index]);
  }
  for (const ShapedMember& member : search.members()) {
    Variant& variant = out.dictionary.variants[member.place];
    const std::vector<double> values = ShapeSearch::values(member, shape);
    const Column column = shaped_column(search.balance(), member.effect, values);
    std::vector<Coefficient> kept;
    if (is_all_shape(member.effect)) {
      whole.push_back(column);
    } else {
      out.dictionary.columns.push_back(column);
      const std::size_t own = out.dictionary.columns.size() - 1;
      const bool coulomb_first = member.effect == "stribeck_friction";
      if (coulomb_first) kept.push_back(variant.coefficients.front());
      kept.push_back({{{own, 1.0}}, 0.0, INFINITY});
      for (std::size_t j = variant.shape.size(); j < variant.coefficients.size(); ++j) {
        kept.push_back(variant.coefficients[j]);
      }
      variant.shape = coulomb_first ? std::vector<std::vector<double>>{{}, values}
                                    : std::vector<std::vector<double>>{values};
    }
    if (is_all_shape(member.effect)) variant.shape = {values};
    variant.coefficients = std::move(kept);
    variant.stated.resize(std::min(variant.stated.size(), variant.coefficients.size()));
  }
  out.target = [target = equation.target, whole](const Signals& signals) {
    std::vector<double> left = target(signals), part(signals.size());
    for (const Column& column : whole) {
      column.fill(signals, part);
      for (std::size_t i = 0; i < left.size(); ++i) left[i] -= part[i];
    }
    return left;
  };
}

/// A value beside a shape is known no better than with the shape open. `whole`: always, the shapes'
/// slopes up to `until`, then the members.
void add_error_of_shapes(const Eigen::MatrixXd& whole, std::size_t always, std::size_t until,
                         Fit& fit) {
  std::vector<Eigen::Index> kept;
  for (Eigen::Index j = 0; j < whole.rows(); ++j) {
    const auto place = static_cast<std::size_t>(j);
    if (place < always || place >= until) kept.push_back(j);
  }
  if (static_cast<Eigen::Index>(kept.size()) == fit.covariance.rows()) {
    fit.covariance = whole(kept, kept);
  }
}

/// Standard errors of the shapes: their derivatives join the linear coefficients in one covariance.
void add_errors(const ShapeSearch& search, const Equation& equation, const SignalSource& source,
                const std::vector<std::size_t>& fold_of_block, const BandOptions& band,
                const optimization::LocalFit& found, RefinedModel& out) {
  Dictionary dictionary = out.dictionary;
  std::vector<Coefficient> always = equation.always;
  for (const ShapedMember& member : search.members()) {
    double scale = 1.0;
    if (!is_all_shape(member.effect)) {
      const std::size_t first =
          out.fit.first_of_member(out.dictionary, member.place, equation.always.size());
      const std::size_t own = member.effect == "stribeck_friction" ? 1 : 0;
      scale = out.fit.values[static_cast<Eigen::Index>(first + own)];
    }
    for (std::size_t k = 0; k < member.count; ++k) {
      dictionary.columns.push_back(
          slope_column(search.balance(), member.effect, ShapeSearch::values(member, found.point), k,
                       search.parameters()[member.first + k].difference_step, scale));
      always.push_back({{{dictionary.columns.size() - 1, 1.0}}, -INFINITY, INFINITY});
    }
  }
  const Gram gram = build_gram(source, false, dictionary, out.target, band);
  if (gram.blocks.size() != fold_of_block.size()) return;
  const auto whole =
      Fitter(gram, dictionary, fold_of_block, always).fit_whole(out.fit.members, true);
  if (whole) add_error_of_shapes(whole->covariance, equation.always.size(), always.size(), out.fit);
  std::size_t at = equation.always.size(), parameter = 0;
  for (const ShapedMember& member : search.members()) {
    for (std::size_t k = 0; k < member.count; ++k, ++at, ++parameter) {
      const auto index = static_cast<Eigen::Index>(at);
      // Starts that end apart at the same loss lie in a valley: it is no narrower than that.
      const double error =
          whole ? std::hypot(std::sqrt(std::max(0.0, whole->covariance(index, index))),
                             found.point_spread[parameter])
                : INFINITY;
      out.shapes.push_back({member.place, search.parameters()[parameter].name,
                            found.point[parameter], error, found.point_spread[parameter]});
    }
  }
}

}  // namespace

std::optional<RefinedModel> refined(const Bench& bench, const Equation& equation, const Fit& model,
                                    const SignalSource& source,
                                    const std::vector<std::size_t>& fold_of_run,
                                    const std::vector<std::size_t>& fold_of_block,
                                    const BandOptions& band) {
  ShapeSearch search(bench, equation, model, source.rows(), fold_of_run, band);
  if (search.is_empty()) return std::nullopt;
  const optimization::LocalFit found = search.search();
  if (found.stop == optimization::FitStop::kFailed) return std::nullopt;
  RefinedModel out;
  fill_dictionary(search, equation, model, found.point, out);
  out.gram = std::make_shared<Gram>(build_gram(source, true, out.dictionary, out.target, band));
  if (out.gram->blocks.size() != fold_of_block.size()) return std::nullopt;
  Members members;
  for (std::size_t m = 0; m < model.members.size(); ++m) members.push_back(m);
  const Fitter fitter(*out.gram, out.dictionary, fold_of_block, equation.always);
  out.fit = fitter.fit(members);
  if (!out.fit.is_valid) return std::nullopt;
  const double noise = fitter.noise_loss(out.fit) * fitter.samples(false);
  if (out.fit.loss + noise > kMostWorse * (model.loss + noise)) return std::nullopt;
  out.starts = found.starts.size();
  out.agreeing = found.agreeing;
  add_errors(search, equation, source, fold_of_block, band, found, out);
  return out;
}

std::vector<Named> refined_names(const RefinedModel& model, std::size_t always_count,
                                 const Balance& balance) {
  std::vector<Named> all = named_effects(model.fit, model.dictionary, always_count, balance);
  for (const ShapeEstimate& shape : model.shapes) {
    for (Named& named : all) {
      if (named.members.front() != shape.member) continue;
      auto& errors = named.effect.standard_error;
      if (shape.name != "length_rad") {
        errors[shape.name] = shape.standard_error;
        if (!std::isfinite(shape.standard_error)) errors[shape.name] = nullptr;  // None is claimed.
        continue;
      }
      // Stiffness is friction over length: relative errors add in squares.
      const double friction = named.effect.parameters["coulomb_Nm"];
      const double of_friction =
          errors["coulomb_Nm"].is_number() ? errors["coulomb_Nm"].get<double>() : INFINITY;
      const double relative =
          std::hypot(shape.standard_error / shape.value, of_friction / friction);
      errors["stiffness_Nm_rad"] = relative * friction / shape.value;
      if (!std::isfinite(relative)) errors["stiffness_Nm_rad"] = nullptr;
    }
  }
  return all;
}

}  // namespace torquewright::identification
