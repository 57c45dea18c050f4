// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "identification/findings/result.hpp"
#include "identification/selection/model_fit.hpp"

namespace torquewright::identification {

/// Widens the standard error of each value found until it reaches the value that the same effect
/// has in another fitted model that the log does not rule out, wherever the two differ by more than
/// noise makes of them: what stands beside an effect decides on its values. Waves stay as they are.
/// Says so in the effect's evidence. `best`, of which `result` tells, may be among the models.
void cover_other_models(const std::vector<const ModelFit*>& models, const ModelFit& best,
                        EquationResult& result);

}  // namespace torquewright::identification
