// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/equation.hpp"

namespace torquewright::identification {

/// The k-th uncertain value of an equation, from the coefficient that stands for its change and
/// that coefficient's error (to first order). Where the motor's side is the target, the residual
/// holds the stated over the true torque constant: curved in the latter.
Correction corrected(const Equation& equation, std::size_t k, double change, double error);

}  // namespace torquewright::identification
