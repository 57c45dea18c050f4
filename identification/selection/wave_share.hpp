// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/findings/result.hpp"
#include "identification/selection/model_fit.hpp"

namespace torquewright::identification {

/// Doubts waves of a torque whose amplitudes are within their own errors, or of which the log shows
/// next to nothing: they pass faster than the band nearly always, or the rest of the model takes
/// them where it is fitted without them, so that their large amplitudes stand for a small remainder
/// (docs/derivations/identification.md section 7).
void doubt_waves_hardly_seen(const ModelFitter& fitter, const ModelFit& fit,
                             EquationResult& result);

}  // namespace torquewright::identification
