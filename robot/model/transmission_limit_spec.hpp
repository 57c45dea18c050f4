// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "io/faults/spec_error.hpp"
#include "robot/model/transmission_limit.hpp"

namespace torquewright::io {
struct Document;
}

namespace torquewright::hopper {

/// Reads `transmission_limit` of a mechanism: a torque and its side, or the file of a gear_strength
/// document, whose limit against a single load holds (docs/derivations/strength.md); that document
/// is added. `at` says where the key stands. Faults are added and the result is empty then.
std::optional<TransmissionLimit> read_transmission_limit(const nlohmann::json& keys,
                                                         const io::Fault& at,
                                                         std::vector<io::Document>& documents,
                                                         std::vector<io::Fault>& faults);

}  // namespace torquewright::hopper
