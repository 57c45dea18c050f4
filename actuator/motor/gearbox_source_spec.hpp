// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <vector>

#include "actuator/motor/actuator.hpp"

namespace torquewright::io {
struct Document;
}

namespace torquewright::actuator {

/// The transmission of a gearbox that stands in a file of its own: ratio, efficiencies and inertia
/// computed from its teeth. `reference` is the actuator's "gearbox", which stands in `actuator` and
/// may hold "friction_coefficient" where the gearbox's document has none. A file among
/// `read_before` is not opened again. The document is appended to `documents`. Throws
/// io::SpecError.
Transmission transmission_from_file(const nlohmann::json& reference, const io::Document& actuator,
                                    std::span<const io::Document> read_before,
                                    std::vector<io::Document>& documents);

}  // namespace torquewright::actuator
