// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "gearbox/problem.hpp"

namespace torquewright::gearbox {

/// What an accepted result proves, in words. Requires a result that was accepted.
std::string claim_sentence(const Problem& problem, const nlohmann::json& result);

}  // namespace torquewright::gearbox
