// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace torquewright::optimization {

/// Returns the x between `lowest` and `highest` that makes x' power x + 2 right' x least, which for
/// columns A and a residual r is |r + A x|^2 with power = A'A and right = A'r. `power` (p x p) is
/// symmetric and positive semidefinite; 0 must lie between the bounds, and is where coordinates
/// stay whose column is nothing. The sum is never more than at 0. Active sets after Stark and
/// Parker, "Bounded-variable least-squares", Computational Statistics 10 (1995): a coordinate that
/// stands at a bound is let go as soon as the sum falls inwards.
Eigen::VectorXd least_squares_in_box(const Eigen::MatrixXd& power, const Eigen::VectorXd& right,
                                     const Eigen::VectorXd& lowest, const Eigen::VectorXd& highest);

}  // namespace torquewright::optimization
