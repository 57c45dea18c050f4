// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "identification/findings/result.hpp"
#include "identification/forward/equation.hpp"
#include "identification/signals/rows.hpp"

namespace torquewright::identification {

/// Every run of an equation by itself, from what two models leave of it at the rows. Of a run that
/// is held out in part the fitted and the held-out rows stand apart.
std::vector<RunResult> run_results(const ForwardEquation& equation, const Rows& rows,
                                   const Eigen::VectorXd& before, const Eigen::VectorXd& after);

/// At most twice `shares` points: the least and the greatest of each of so many equal shares, where
/// they stand, so that nothing that sticks out is lost.
Curve thinned(const Curve& curve, std::size_t shares);

}  // namespace torquewright::identification
