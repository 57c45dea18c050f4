// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace torquewright::identification {

/// What a Fisher information matrix says about each of its n parameters.
struct Separability {
  /// Standard error in the parameter's unit. Infinite where the parameter is not excited, or is the
  /// same as others.
  std::vector<double> standard_error;
  /// 1 less the squared multiple correlation with all the others: 1 stands alone, 0 is the same as
  /// a combination of them.
  std::vector<double> share;
  /// The parameter with the largest partial correlation, for each parameter.
  std::vector<std::size_t> nearest;
  /// Smallest eigenvalue of the information scaled to a unit diagonal.
  double smallest_eigenvalue = 0.0;
};

/// Computes separability from a Fisher information matrix: (n x n), symmetric, semidefinite, in
/// 1/(the parameters' units). A parameter whose diagonal is 0 was not excited: it takes no part.
Separability separability(const Eigen::MatrixXd& information);

}  // namespace torquewright::identification
