// SPDX-License-Identifier: Apache-2.0
#include "identification/shape_search.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace torquewright::identification {

ShapeSearch::ShapeSearch(const Bench& bench, const Equation& equation, const Fit& model,
                         const std::vector<Signals>& signals,
                         const std::vector<std::size_t>& fold_of_run, const BandOptions& band)
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

optimization::LocalFit ShapeSearch::search() {
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

double ShapeSearch::loss(std::span<const double> shape) const {
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

std::vector<double> ShapeSearch::values(const ShapedMember& member, std::span<const double> shape) {
  const auto part = shape.subspan(member.first, member.count);
  return {part.begin(), part.end()};
}

std::vector<double> ShapeSearch::weights_of(std::size_t place) const {
  const Variant& variant = equation_.dictionary.variants[model_.members[place]];
  const std::size_t first =
      model_.first_of_member(equation_.dictionary, place, equation_.always.size());
  std::vector<double> weights;
  for (std::size_t j = 0; j < variant.coefficients.size(); ++j) {
    weights.push_back(model_.values[static_cast<Eigen::Index>(first + j)]);
  }
  return weights;
}

bool ShapeSearch::is_shaped(std::size_t place) const {
  return std::any_of(members_.begin(), members_.end(),
                     [&](const ShapedMember& member) { return member.place == place; });
}

/// Columns that no shape moves: combined as the model combines them, values left open.
std::vector<Column> ShapeSearch::fixed_columns() const {
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

void ShapeSearch::combine(std::size_t coefficient, const Signals& signals,
                          std::vector<double>& out) const {
  std::fill(out.begin(), out.end(), 0.0);
  std::vector<double> part(out.size());
  for (const auto& term : model_.coefficients[coefficient].terms) {
    equation_.dictionary.columns[term.column].fill(signals, part);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += term.weight * part[i];
  }
}

/// Rows of all stretches that may be fitted, columns and the target behind.
Eigen::MatrixXd ShapeSearch::rows_of(const std::vector<Column>& columns,
                                     const Target& target) const {
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

}  // namespace torquewright::identification
