// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/analysis.hpp"

namespace torquewright::identification {

/// The same by the forward model: effects are fitted as the actuator's law has them, and judged as
/// sets. Each with everything that the joint's channels allow.
std::vector<EquationResult> analyse_forward(const Rig& rig, const Log& log, std::size_t joint,
                                            const std::vector<const actuator::Actuator*>& actuators,
                                            const AnalysisOptions& options);

}  // namespace torquewright::identification
