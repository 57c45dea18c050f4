// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "gearbox/problem.hpp"
#include "gearbox/proof/reading/faults.hpp"

namespace torquewright::gearbox {

/// A design with profile shifts as a result lists it; nothing, and a fault, where one is missing.
std::optional<Design> shifted_design(const Problem& problem, const nlohmann::json& json,
                                     const std::string& place, proof::Faults& faults);

/// Whether a design with these face widths [mm, by layer] is one that the problem with `synthesis`
/// asks for: all that `evaluate` asks, the load that `strength` finds borne, and what the problem
/// lets the synthesis choose. Adds a fault for each thing that it is not.
void check_sized_design(const Problem& problem, const Design& design,
                        const std::array<double, 2>& face_width_mm, const std::string& place,
                        proof::Faults& faults);

}  // namespace torquewright::gearbox
