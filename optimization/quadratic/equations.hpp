// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "optimization/quadratic/program.hpp"

namespace torquewright::optimization {

/// What a program's equations leave free: x = particular + free y, with `free` orthonormal. By
/// Householder reflections of the equations' rows, the longest remainder first. Memory is taken
/// where sizes grow alone.
class EquationSpace {
 public:
  /// False where equations contradict each other: contradicting() names them.
  [[nodiscard]] bool set(const QuadraticProgram& program);

  const Eigen::VectorXd& particular() const { return particular_; }
  /// (n x room): directions that no equation feels.
  auto free() const { return basis_.rightCols(basis_.cols() - rank_); }
  Eigen::Index room() const { return basis_.cols() - rank_; }

  bool is_equation(Eigen::Index row) const { return place_of_[static_cast<std::size_t>(row)] >= 0; }
  const std::vector<Eigen::Index>& contradicting() const { return contradicting_; }

  /// Adds to the multipliers what equations must bear of a gradient (n x 1) for the sum to vanish;
  /// of equations that depend on each other some bear nothing.
  void add_multipliers(const Eigen::VectorXd& gradient, Eigen::VectorXd& multipliers);
  /// Adds the equations that make up a sum of other rows (n x 1) which they determine; `size` is
  /// that of what was summed, whose rounding is no part.
  void add_parts_of(const Eigen::VectorXd& sum, double size, std::vector<Eigen::Index>& rows);

 private:
  void gather(const QuadraticProgram& program);
  void factor();
  void form_basis();
  bool place(const QuadraticProgram& program);
  void solve_upper(Eigen::Index rank);

  std::vector<Eigen::Index> equations_;  ///< Rows of the program, in the order of the pivots.
  std::vector<Eigen::Index> place_of_;   ///< By row of the program: its place there; else -1.
  std::vector<Eigen::Index> contradicting_;
  Eigen::MatrixXd
      columns_;  ///< (n x equations): rows of length 1; then R above, reflections below.
  Eigen::VectorXd lengths_, scales_;
  Eigen::VectorXd particular_, parts_, workspace_;
  Eigen::MatrixXd basis_;  ///< (n x n) Q: first the equations' space, then what is free.
  Eigen::Index rank_ = 0;
};

}  // namespace torquewright::optimization
