// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/objectives/flight_phase.hpp"

#include <fmt/format.h>

#include "io/faults/refusal.hpp"

namespace torquewright::hopper {

const PhaseVariables& longest_flight(const FlipProgram& program, std::string_view objective) {
  const PhaseVariables* longest = nullptr;
  const auto guessed_s = [&](const PhaseVariables& phase) {
    return program.program.starts()[static_cast<std::size_t>(phase.duration)];
  };
  for (std::size_t i = 0; i < program.phases.size(); ++i) {
    const PhaseVariables& phase = program.phases[i];
    if (!program.mesh[i].stance.is_flight()) continue;
    if (longest == nullptr || guessed_s(phase) > guessed_s(*longest)) longest = &phase;
  }
  if (longest == nullptr) {
    io::refuse("--objective",
               fmt::format("{} is about a flight, and no phase of this motion flies", objective));
  }
  return *longest;
}

}  // namespace torquewright::hopper
