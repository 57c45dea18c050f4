// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "dynamics/jet.hpp"
#include "dynamics/jet_functions.hpp"
#include "optimization/nonlinear/program.hpp"

namespace torquewright::optimization {

/// Rows that a formula states: formula(x) with x a vector of any kind of number (at most
/// dynamics::kMostVariables of them) yields a vector of the rows, of that kind. Its derivatives are
/// taken by jets.
template <typename Formula>
class FormulaRows final : public Rows {
 public:
  FormulaRows(std::vector<int> variables, std::vector<Bounds> bounds, Formula formula)
      : Rows("formula", std::move(variables), bounds, std::vector<double>(bounds.size(), 1.0)),
        formula_(std::move(formula)) {}
  FormulaRows(std::vector<int> variables, std::vector<Bounds> bounds, std::vector<double> scales,
              Formula formula)
      : Rows("formula", std::move(variables), std::move(bounds), std::move(scales)),
        formula_(std::move(formula)) {}

  void values(const VectorIn& x, VectorOut rows) const override {
    const auto out = formula_(std::vector<double>(x.begin(), x.end()));
    for (Eigen::Index i = 0; i < size(); ++i) rows(i) = out[static_cast<std::size_t>(i)];
  }
  void slopes(const VectorIn& x, MatrixOut jacobian) const override {
    const auto out = formula_(seeded<dynamics::Jet>(x));
    for (Eigen::Index i = 0; i < size(); ++i) {
      for (Eigen::Index j = 0; j < width(); ++j) {
        jacobian(i, j) = out[static_cast<std::size_t>(i)].slope(static_cast<int>(j));
      }
    }
  }
  void curvatures(const VectorIn& x, const VectorIn& multipliers,
                  MatrixOut hessian) const override {
    const auto out = formula_(seeded<dynamics::Jet2>(x));
    dynamics::Jet2 sum(0.0);
    for (Eigen::Index i = 0; i < size(); ++i) {
      sum += multipliers(i) * out[static_cast<std::size_t>(i)];
    }
    for (Eigen::Index i = 0; i < width(); ++i) {
      for (Eigen::Index j = 0; j < width(); ++j) {
        hessian(i, j) = sum.curvature(static_cast<int>(i), static_cast<int>(j));
      }
    }
  }

 private:
  template <typename Number>
  static std::vector<Number> seeded(const VectorIn& x) {
    std::vector<Number> seeds;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      seeds.push_back(Number::variable(x(i), static_cast<int>(i)));
    }
    return seeds;
  }

  Formula formula_;
};

template <typename Formula>
std::unique_ptr<const Rows> formula_rows(std::vector<int> variables, std::vector<Bounds> bounds,
                                         Formula formula) {
  return std::make_unique<const FormulaRows<Formula>>(std::move(variables), std::move(bounds),
                                                      std::move(formula));
}

/// formula(x) yields one number.
template <typename Formula>
std::unique_ptr<const Rows> formula_cost(std::vector<int> variables, Formula formula) {
  return formula_rows(
      std::move(variables), {{}},
      [formula = std::move(formula)]<typename Number>(const std::vector<Number>& x) {
        return std::vector<Number>{formula(x)};
      });
}

}  // namespace torquewright::optimization
