// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

#include "hopper/contact/second_order_cone.hpp"

namespace torquewright::hopper {

/// Forces on several points that come as near as they can to a sum that is asked for:
///
///   minimise |A x - b|^2 + kTieBreaker |x|^2,  x = (x_1, ..., x_n), each x_i in its friction cone
///   |(x_i)_t| <= mu_i (x_i)_n,  with axes (tangent, tangent, normal).
///
/// Where many forces have the same sum the tie-breaker picks the shortest, or, given a guide g, by
/// |x - g|^2 by weights in its place the nearest to it. Primal-dual interior
/// points with Nesterov-Todd scaling; docs/derivations/whole_body_check.md eqs. (6)-(9). The value
/// found lies within kGap of the least one, by its duality gap.
///
/// Expects a problem of about unit size: A, b and x in units of the robot's weight and size.
class ConeLeastSquares {
 public:
  static constexpr double kTieBreaker = 1e-8;
  static constexpr double kGap = 1e-9;

  /// Forces that the answer is to be near to.
  struct Guide {
    Eigen::VectorXd x;        ///< (3 n x 1)
    Eigen::VectorXd weights;  ///< (3 n x 1), positive.
  };

  enum class Status { kSolved, kStalled };

  /// Room for that many points; does not allocate after that for as many or fewer.
  explicit ConeLeastSquares(Eigen::Index most_points);

  /// A (m x 3 n), b (m x 1), friction (n x 1), all finite, n at most what
  /// was asked for. Solution: x(). kStalled: rounding ended the search before its gap closed; x()
  /// is the best found, inside its cones.
  Status solve(const Eigen::Ref<const Eigen::MatrixXd>& A,
               const Eigen::Ref<const Eigen::VectorXd>& b,
               const Eigen::Ref<const Eigen::VectorXd>& friction, const Guide* guide = nullptr);

  /// (3 n x 1), a point after the other.
  Eigen::Ref<const Eigen::VectorXd> x() const { return x_.head(size_); }

 private:
  bool solve_without_cones(const Eigen::Ref<const Eigen::VectorXd>& friction);
  Status solve_inside_cones();
  void start();
  void take_step(double centring, bool is_prediction);
  double share_of_step() const;
  double gap() const;

  Eigen::Index size_ = 0;
  Eigen::Index points_ = 0;
  // Scaled so that each cone is |t| <= n: x = D s, D = diag(mu, mu, 1).
  Eigen::MatrixXd normal_;  ///< D (A^T A + tie-breaker) D.
  Eigen::VectorXd pull_;    ///< D A^T b.
  Eigen::VectorXd scale_;   ///< D's diagonal.
  Eigen::VectorXd x_;       ///< s, and at the end x.
  Eigen::VectorXd best_;    ///< The s whose gap and balance were the best.
  Eigen::VectorXd dual_;
  Eigen::VectorXd residual_;  ///< H s - pull - dual.
  Eigen::VectorXd step_;
  Eigen::VectorXd dual_step_;
  Eigen::VectorXd complement_;  ///< W^-1 of what complementarity asks for.
  Eigen::MatrixXd system_;
  std::vector<Eigen::Matrix3d> scaling_;    ///< W, by point,
  std::vector<Eigen::Matrix3d> unscaling_;  ///< and its inverse.
  Eigen::LDLT<Eigen::MatrixXd> factor_;
};

}  // namespace torquewright::hopper
