// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/proof/claims/claim.hpp"
#include "gearbox/proof/reading/json_reading.hpp"

namespace torquewright::gearbox::proof {

/// Reads {"teeth": {...}, "planet_count", "module_mm"}; further keys are others' business. A fault
/// and empty unless the teeth are those of all gears of the topology, positive and coaxial, and
/// planets and module are choices of the problem.
std::optional<Candidate> read_candidate(const Problem& problem, const Json* json,
                                        const std::string& place, Faults& faults);

/// A fault for every constraint among these that the candidate violates.
void check_feasibility(const Problem& problem, const std::vector<Constraint>& constraints,
                       const Candidate& candidate, const std::string& place, Faults& faults);

}  // namespace torquewright::gearbox::proof
