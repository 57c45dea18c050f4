// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/demand/base_residual.hpp"

namespace torquewright::hopper {

/// Returns the samples that ask for more than nothing explains and may be left out, ascending: they
/// are no more than options.left_out_share of all, and what they ask for would not move the robot
/// much, less than the residual's limit on the mean over its lasting window. Empty: there are none,
/// or they are too many, or too strong a push to be an error of some rows.
std::vector<Eigen::Index> rows_to_leave_out(const CheckedMotion& checked,
                                            const BaseResidual& residual);

/// Replaces columns of a table by what lies straight between those beside that are not among them.
/// Requires ascending columns, not all.
void read_between(const Motion& motion, const std::vector<Eigen::Index>& columns,
                  Eigen::MatrixXd& table);

/// Does that to all that the demand says of these samples: torques, forces, momenta, what is left.
void leave_out(const Motion& motion, const std::vector<Eigen::Index>& rows, Demand& demand);

/// Returns what is to be said of the samples that were left out; `whole` is the residual with them.
/// Empty: none was.
std::vector<Finding> left_out_findings(const CheckedMotion& checked, const BaseResidual& whole);

}  // namespace torquewright::hopper
