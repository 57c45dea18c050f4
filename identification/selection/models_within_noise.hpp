// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "identification/findings/result.hpp"
#include "identification/selection/search.hpp"
#include "identification/signals/bench.hpp"

namespace torquewright::identification {

/// Returns the model that was taken, and behind it those that the log cannot tell from it, in the
/// order of their loss where they were not fitted.
std::vector<ModelWithinNoise> models_within_noise(const Bench& bench, const ModelFitter& fitter,
                                                  const Found& found);

}  // namespace torquewright::identification
