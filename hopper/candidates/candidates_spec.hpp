// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "hopper/candidates/candidates.hpp"

namespace torquewright::hopper {

/// The `candidates` of a check_report, in the order given.
nlohmann::ordered_json candidates_json(const Robot& robot,
                                       const std::vector<CandidateResult>& results);

/// Writes a candidate's result on one line, which processes hand on.
std::string candidate_text(const CandidateResult& result);
CandidateResult candidate_of(const std::string& text);

}  // namespace torquewright::hopper
