// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "hopper/planning/model/plan_model.hpp"
#include "hopper/planning/model/plan_variables.hpp"

namespace torquewright::hopper {

/// Returns the variables of the flight that lasts longest in the guess. io::SpecError, naming the
/// objective that asks, where no phase flies.
const PhaseVariables& longest_flight(const FlipProgram& program, std::string_view objective);

}  // namespace torquewright::hopper
