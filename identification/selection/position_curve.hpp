// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "identification/findings/result.hpp"
#include "identification/selection/model_fit.hpp"

namespace torquewright::identification {

/// Doubts what a model holds as laws of the output's position (springs, stops, ripple of the gears)
/// where a polynomial of it with no more coefficients than they have, in their place, leaves less
/// than half of the squares beyond noise: the torque is another function of the position.
/// docs/derivations/identification.md section 12.
void doubt_laws_of_position(const ModelFitter& fitter, const ModelFit& fit, EquationResult& result);

}  // namespace torquewright::identification
