// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "identification/findings/result.hpp"
#include "identification/selection/analysis_options.hpp"

namespace torquewright::identification {

/// Analyses every equation that a joint's channels allow: residual structure, search and verdict
/// (docs/derivations/identification.md sections 5 to 13).
std::vector<EquationResult> analyse(const Rig& rig, const Log& log, std::size_t joint,
                                    const std::vector<const actuator::Actuator*>& actuators,
                                    const AnalysisOptions& options = {});

}  // namespace torquewright::identification
