// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace torquewright::report {

/// The samples of a curve that a picture needs: at most some four a bucket of so many samples, and
/// of each bucket the least and the greatest value. NaN is a gap: kept where it begins and ends.
std::vector<Eigen::Index> curve_samples(const Eigen::VectorXd& values, Eigen::Index buckets);

/// The samples that a cursor may stand on: all, where there are no more than `most`; else `most`
/// spread over the time, the least and the greatest of each column, and `wanted`. Ascending.
std::vector<Eigen::Index> cursor_samples(const std::vector<double>& times_s,
                                         const std::vector<const Eigen::VectorXd*>& columns,
                                         const std::vector<Eigen::Index>& wanted,
                                         Eigen::Index most);

}  // namespace torquewright::report
