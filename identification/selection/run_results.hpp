// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "identification/findings/result.hpp"
#include "identification/forward/equation.hpp"
#include "identification/signals/rows.hpp"

namespace torquewright::identification {

/// Returns the result of each run of an equation, from the residuals of two models. A run that is
/// held out in part has two results, of its fitted and of its held-out rows.
std::vector<RunResult> run_results(const ForwardEquation& equation, const Rows& rows,
                                   const Eigen::VectorXd& before, const Eigen::VectorXd& after);

/// Thins a curve to at most 2 `shares` points: the least and the greatest of each of so many equal
/// shares, so that no peak is lost.
Curve thinned(const Curve& curve, std::size_t shares);

}  // namespace torquewright::identification
