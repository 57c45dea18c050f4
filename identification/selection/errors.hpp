// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/forward/equation.hpp"
#include "identification/signals/rows.hpp"

namespace torquewright::identification {

/// Root mean squares over rows that were fitted and that were not, in the equation's unit.
Errors errors_over(const ForwardEquation& equation, const Rows& rows,
                   const Eigen::VectorXd& residual);

}  // namespace torquewright::identification
