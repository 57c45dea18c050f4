// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <utility>

#include "dynamics/seeds.hpp"
#include "optimization/nonlinear/program.hpp"

namespace torquewright::hopper {

/// Rows of a program from a law that stands on any scalar: law(x, rows), x a vector of the row's
/// variables (at most dynamics::kMostVariables) and rows one of as many numbers as there are
/// bounds. Derivatives are exact but for rounding.
template <typename Law>
class JetRows final : public optimization::Rows {
 public:
  JetRows(std::string name, std::vector<int> variables, std::vector<optimization::Bounds> bounds,
          std::vector<double> scales, Law law)
      : Rows(std::move(name), std::move(variables), std::move(bounds), std::move(scales)),
        law_(std::move(law)) {
    if (width() > dynamics::kMostVariables) {
      throw std::invalid_argument(this->name() + ": more variables than a jet has slopes");
    }
  }

  void values(const VectorIn& x, VectorOut rows) const override {
    dynamics::VectorX<double> out(size());
    law_(dynamics::VectorX<double>(x), out);
    rows = out;
  }

  void slopes(const VectorIn& x, MatrixOut jacobian) const override {
    dynamics::VectorX<dynamics::Jet> out(size());
    law_(dynamics::seeded<dynamics::Jet>(x, 0), out);
    for (Eigen::Index row = 0; row < size(); ++row) {
      for (Eigen::Index i = 0; i < width(); ++i) {
        jacobian(row, i) = out[row].slope(static_cast<int>(i));
      }
    }
  }

  void curvatures(const VectorIn& x, const VectorIn& multipliers,
                  MatrixOut hessian) const override {
    dynamics::VectorX<dynamics::Jet2> out(size());
    law_(dynamics::seeded<dynamics::Jet2>(x, 0), out);
    dynamics::Jet2 sum(0.0);
    for (Eigen::Index row = 0; row < size(); ++row) sum += multipliers[row] * out[row];
    for (Eigen::Index i = 0; i < width(); ++i) {
      for (Eigen::Index j = 0; j < width(); ++j) {
        hessian(i, j) = sum.curvature(static_cast<int>(i), static_cast<int>(j));
      }
    }
  }

 private:
  Law law_;
};

template <typename Law>
std::unique_ptr<const optimization::Rows> jet_rows(std::string name, std::vector<int> variables,
                                                   std::vector<optimization::Bounds> bounds,
                                                   std::vector<double> scales, Law law) {
  return std::make_unique<const JetRows<Law>>(std::move(name), std::move(variables),
                                              std::move(bounds), std::move(scales), std::move(law));
}

}  // namespace torquewright::hopper
