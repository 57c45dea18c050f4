// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "identification/findings/result.hpp"
#include "identification/selection/model_fit.hpp"

namespace torquewright::identification {

/// Doubts laws of the output's position (springs, stops, ripple of the gears) in a model where a
/// polynomial of the position with no more coefficients, in their place, leaves less than half of
/// the squares beyond noise: the torque is then another function of the position
/// (docs/derivations/identification.md section 12).
void doubt_laws_of_position(const ModelFitter& fitter, const ModelFit& fit, EquationResult& result);

}  // namespace torquewright::identification
