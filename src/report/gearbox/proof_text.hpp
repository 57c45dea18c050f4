// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "gearbox/verification/verification_json.hpp"

namespace torquewright::report {

/// What the check of a proof found, with every fault.
std::string proof_text(const gearbox::Verification& found);

}  // namespace torquewright::report
