// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace torquewright::hopper {

/// Forces on several points that come as near as they can to a sum that is asked for:
///
///   minimise |A x - b|^2 + kTieBreaker |x|^2,  x = (x_1, ..., x_n), each x_i in its friction cone
///   |(x_i)_t| <= mu_i (x_i)_n,  with axes (tangent, tangent, normal).
///
/// Where many forces have the same sum the tie-breaker picks the shortest, and costs no more than
/// kTieBreaker of it. Interior points, docs/derivations/whole_body_check.md eqs. (6)-(9): the
/// value found lies within kGap of the least one, by its own duality bound.
///
/// Expects a problem of about unit size: A, b and x in units of the robot's weight and size.
class ConeLeastSquares {
 public:
  static constexpr double kTieBreaker = 1e-10;
  static constexpr double kGap = 1e-14;
  static constexpr double kLeastFriction = 1e-6;  ///< A smooth contact counts as this rough.

  enum class Status { kSolved, kStalled };

  /// Room for that many points; does not allocate after that for as many or fewer.
  explicit ConeLeastSquares(Eigen::Index most_points);

  /// One row of `friction` a point, three columns of A a point. Solution: x(). kStalled: rounding
  /// ended the search before its bound did; x() is the best found, inside its cones.
  Status solve(const Eigen::Ref<const Eigen::MatrixXd>& A,
               const Eigen::Ref<const Eigen::VectorXd>& b,
               const Eigen::Ref<const Eigen::VectorXd>& friction);

  Eigen::Ref<const Eigen::VectorXd> x() const { return x_.head(size_); }

 private:
  bool solve_without_cones(const Eigen::Ref<const Eigen::VectorXd>& b,
                           const Eigen::Ref<const Eigen::VectorXd>& friction);
  void start(const Eigen::Ref<const Eigen::VectorXd>& friction);
  bool step(double barrier, const Eigen::Ref<const Eigen::VectorXd>& friction);
  double value(const Eigen::VectorXd& x, double barrier,
               const Eigen::Ref<const Eigen::VectorXd>& friction) const;

  Eigen::Index size_ = 0;
  Eigen::MatrixXd normal_;  ///< A^T A + kTieBreaker.
  Eigen::VectorXd pull_;    ///< A^T b.
  Eigen::MatrixXd hessian_;
  Eigen::VectorXd gradient_;
  Eigen::VectorXd x_;
  Eigen::VectorXd direction_;
  Eigen::VectorXd trial_;
  Eigen::LDLT<Eigen::MatrixXd> factor_;
};

}  // namespace torquewright::hopper
