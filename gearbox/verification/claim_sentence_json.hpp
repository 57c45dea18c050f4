// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "gearbox/problem.hpp"

namespace torquewright::gearbox {

/// Returns in words what an accepted result proves. Requires a result that was accepted.
std::string claim_sentence(const Problem& problem, const nlohmann::json& result);

}  // namespace torquewright::gearbox
