// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "optimization/quadratic/active_set.hpp"
#include "optimization/quadratic/equations.hpp"
#include "optimization/quadratic/program.hpp"

namespace torquewright::optimization {

/// Solves convex quadratic programs, each from the bounds that were active in the one before:
/// equations are taken out, the rest is ActiveSet's; where the cost is flat, by proximal steps to
/// the exact optimum. Takes no memory once it has solved a program of a size, up to some 100
/// unknowns. One object serves one thread. docs/derivations/quadratic_program.md
class QuadraticSolver {
 public:
  /// The solution stands until the next solve. std::invalid_argument where sizes do not fit, a
  /// number is not finite, a lower bound is +infinity or an upper one -infinity.
  [[nodiscard]] const QuadraticSolution& solve(const QuadraticProgram& program);

  /// Forgets which bounds were active.
  void forget() { active_set_.forget(); }

 private:
  bool crossed(const QuadraticProgram& program);
  bool reduce(const QuadraticProgram& program);
  bool factor(const QuadraticProgram& program);
  bool take_root(double added);
  void search(const QuadraticProgram& program);
  bool falls_forever(const QuadraticProgram& program);
  void name_contradiction(const QuadraticProgram& program);
  void answer(const QuadraticProgram& program);

  EquationSpace equations_;
  ActiveSet active_set_;
  QuadraticSolution solution_;
  Eigen::MatrixXd cost_, half_;  ///< Of the free unknowns (r x r); cost times basis (n x r).
  Eigen::MatrixXd root_;         ///< L of the cost and what is added to it.
  Eigen::VectorXd slope_, gradient_, y_, step_, curve_, sum_;
  double flat_ = 0.0;  ///< What is added to the cost for it to have an inverse; 0: nothing.
  std::vector<double> factors_;
};

}  // namespace torquewright::optimization
