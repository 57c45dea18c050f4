// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace torquewright::identification {

/// What a Fisher information matrix says of each of its n parameters.
struct Separability {
  /// In the parameter's unit. Infinite: not excited, or the same as others.
  std::vector<double> standard_error;
  /// 1 less the squared multiple correlation with all the others: 1 stands alone, 0 is the same as
  /// a combination of them.
  std::vector<double> share;
  std::vector<std::size_t> nearest;  ///< The parameter with the largest partial correlation.
  double smallest_eigenvalue = 0.0;  ///< Of the information scaled to a unit diagonal.
};

/// (n x n) Symmetric, semidefinite, in 1/(the parameters' units). A parameter whose diagonal is 0
/// was not excited: it takes no part.
Separability separability(const Eigen::MatrixXd& information);

}  // namespace torquewright::identification
