// SPDX-License-Identifier: Apache-2.0
#include "identification/refinement.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "optimization/local_fit.hpp"

namespace torquewright::identification {
namespace {

/// Of the squared error with the noise in it, against the grid's: neighbours on the grid together
/// follow noise a little better than the one law that stands for them.
constexpr double kMostWorse = 1.01;

/// A member with curved parameters, and where they stand among all of them.
struct ShapedMember {
  std::size_t place;
  std::string effect;
  std::size_t first;
  std::size_t count;
};

class ShapeSearch {
 public:
  ShapeSearch(const Bench& bench, const Equation& equation, const Fit& model,
              const std::vector<Signals>& signals, const std::vector<std::size_t>& fold_of_run,
              const BandOptions& band)
      : balance_(std::make_shared<Balance>(bench)),
        equation_(equation),
        model_(model),
        signals_(signals),
        fold_of_run_(fold_of_run),
        band_(band) {
    const Extent extent = extent_of(signals);
    for (std::size_t m = 0; m < model.members.size(); ++m) {
      const Variant& variant = equation.dictionary.variants[model.members[m]];
      const auto own = shape_parameters(variant, weights_of(m), extent);
      if (own.empty()) continue;
      members_.push_back({m, variant.effect, parameters_.size(), own.size()});
      parameters_.insert(parameters_.end(), own.begin(), own.end());
    }
  }

  bool is_empty() const { return members_.empty(); }
  const std::vector<ShapeParameter>& parameters() const { return parameters_; }
  const std::vector<ShapedMember>& members() const { return members_; }

  optimization::LocalFit search() {
    fixed_ = rows_of(fixed_columns(), equation_.target);
    std::vector<optimization::FitVariable> variables;
    for (const ShapeParameter& each : parameters_) {
      variables.push_back(
          {each.lowest, each.highest, std::clamp(each.start, each.lowest, each.highest), true});
    }
    optimization::FitOptions options;
    options.starts = 3;
    options.most_evaluations = 120;
    options.tolerance = 1e-5;
    return optimization::fit_locally([&](std::span<const double> shape) { return loss(shape); },
                                     variables, options);
  }

  double loss(std::span<const double> shape) const {
    Eigen::MatrixXd all = fixed_;
    const Eigen::Index target = fixed_.cols() - 1;
    std::vector<Column> free;
    for (const ShapedMember& member : members_) {
      const Column column = shaped_column(balance_, member.effect, values(member, shape));
      if (is_all_shape(member.effect)) {
        all.col(target) -= rows_of({column}, equation_.target).col(0);
      } else {
        free.push_back(column);
      }
    }
    const Eigen::MatrixXd shaped = rows_of(free, equation_.target);
    Eigen::MatrixXd matrix(all.rows(), target + static_cast<Eigen::Index>(free.size()));
    matrix << all.leftCols(target), shaped.leftCols(static_cast<Eigen::Index>(free.size()));
    const Eigen::VectorXd right = all.col(target);
    if (matrix.cols() == 0) return right.squaredNorm();
    const Eigen::MatrixXd normal = matrix.transpose() * matrix;
    const Eigen::VectorXd product = matrix.transpose() * right;
    const Eigen::LDLT<Eigen::MatrixXd> factors(normal);
    if (factors.info() != Eigen::Success) return INFINITY;
    return right.squaredNorm() - product.dot(factors.solve(product));
  }

  static std::vector<double> values(const ShapedMember& member, std::span<const double> shape) {
    const auto part = shape.subspan(member.first, member.count);
    return {part.begin(), part.end()};
  }

  const std::shared_ptr<Balance>& balance() const { return balance_; }

 private:
  std::vector<double> weights_of(std::size_t place) const {
    const Variant& variant = equation_.dictionary.variants[model_.members[place]];
    const std::size_t first =
        model_.first_of_member(equation_.dictionary, place, equation_.always.size());
    std::vector<double> weights;
    for (std::size_t j = 0; j < variant.coefficients.size(); ++j) {
      weights.push_back(model_.values[static_cast<Eigen::Index>(first + j)]);
    }
    return weights;
  }

  bool is_shaped(std::size_t place) const {
    return std::any_of(members_.begin(), members_.end(),
                       [&](const ShapedMember& member) { return member.place == place; });
  }

  /// Columns that no shape moves: combined as the model combines them, values left open.
  std::vector<Column> fixed_columns() const {
    std::vector<Column> columns;
    const auto add = [&](std::size_t coefficient) {
      columns.push_back({"", [this, coefficient](const Signals& signals, std::vector<double>& out) {
                           combine(coefficient, signals, out);
                         }});
    };
    for (std::size_t j = 0; j < equation_.always.size(); ++j) add(j);
    for (std::size_t m = 0; m < model_.members.size(); ++m) {
      const Variant& variant = equation_.dictionary.variants[model_.members[m]];
      const std::size_t first =
          model_.first_of_member(equation_.dictionary, m, equation_.always.size());
      for (std::size_t j = 0; j < variant.coefficients.size(); ++j) {
        // Of a shaped member only what is not on the grid (Coulomb beside Stribeck) stays.
        const bool on_grid = j < variant.shape.size() && !variant.shape[j].empty();
        if (!is_shaped(m) || !on_grid) add(first + j);
      }
    }
    return columns;
  }

  void combine(std::size_t coefficient, const Signals& signals, std::vector<double>& out) const {
    std::fill(out.begin(), out.end(), 0.0);
    std::vector<double> part(out.size());
    for (const auto& term : model_.coefficients[coefficient].terms) {
      equation_.dictionary.columns[term.column].fill(signals, part);
      for (std::size_t i = 0; i < out.size(); ++i) out[i] += term.weight * part[i];
    }
  }

  /// Rows of all stretches that may be fitted, columns and the target behind.
  Eigen::MatrixXd rows_of(const std::vector<Column>& columns, const Target& target) const {
    std::vector<const Column*> pointers;
    for (const Column& column : columns) pointers.push_back(&column);
    std::vector<Eigen::MatrixXd> parts;
    Eigen::Index rows = 0;
    for (const Signals& stretch : signals_) {
      if (fold_of_run_[stretch.run] == Fitter::kNoFold) continue;
      parts.push_back(band_rows(stretch, pointers, target, band_).values);
      rows += parts.back().rows();
    }
    Eigen::MatrixXd all(rows, static_cast<Eigen::Index>(columns.size()) + 1);
    Eigen::Index at = 0;
    for (const Eigen::MatrixXd& part : parts) {
      all.middleRows(at, part.rows()) = part;
      at += part.rows();
    }
    return all;
  }

  std::shared_ptr<Balance> balance_;
  const Equation& equation_;
  const Fit& model_;
  const std::vector<Signals>& signals_;
  const std::vector<std::size_t>& fold_of_run_;
  BandOptions band_;
  std::vector<ShapedMember> members_;
  std::vector<ShapeParameter> parameters_;
  Eigen::MatrixXd fixed_;
};

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
void add_doubt_of_shapes(const Eigen::MatrixXd& whole, std::size_t always, std::size_t until,
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
  if (whole) add_doubt_of_shapes(whole->covariance, equation.always.size(), always.size(), out.fit);
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
