// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "hopper/candidates/candidates.hpp"

namespace torquewright::hopper {

/// The `candidates` of a check_report, in the order given.
nlohmann::ordered_json candidates_json(const Robot& robot,
                                       const std::vector<CandidateResult>& results);

}  // namespace torquewright::hopper
