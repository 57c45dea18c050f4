// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/forward/equation.hpp"
#include "identification/signals/rows.hpp"

namespace torquewright::identification {

/// Returns root mean squares over the fitted and the held-out rows, in the equation's unit.
Errors errors_over(const ForwardEquation& equation, const Rows& rows,
                   const Eigen::VectorXd& residual);

}  // namespace torquewright::identification
