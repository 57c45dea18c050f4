// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "gearbox/verification/verification_json.hpp"

namespace torquewright::report {

/// What the check of a proof found, for programs.
nlohmann::ordered_json proof_json(const gearbox::Verification& found);

}  // namespace torquewright::report
