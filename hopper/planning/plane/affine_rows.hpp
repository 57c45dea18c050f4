// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "optimization/nonlinear/program.hpp"

namespace torquewright::hopper {

/// Rows that are a constant matrix times their variables, of which there may be any number.
class AffineRows final : public optimization::Rows {
 public:
  /// Makes rows of `matrix` (bounds x variables) times the variables.
  AffineRows(std::string name, std::vector<int> variables, std::vector<optimization::Bounds> bounds,
             std::vector<double> scales, Eigen::MatrixXd matrix)
      : Rows(std::move(name), std::move(variables), std::move(bounds), std::move(scales)),
        matrix_(std::move(matrix)) {}

  void values(const VectorIn& x, VectorOut rows) const override { rows = matrix_ * x; }
  void slopes(const VectorIn&, MatrixOut jacobian) const override { jacobian = matrix_; }
  void curvatures(const VectorIn&, const VectorIn&, MatrixOut hessian) const override {
    hessian.setZero();
  }
  bool is_affine() const override { return true; }

 private:
  Eigen::MatrixXd matrix_;
};

}  // namespace torquewright::hopper
