// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tests/oracles/gearbox_enumeration.hpp"

namespace torquewright::bench {

/// What a solver says: status is optimal, infeasible, or anything else if it does not claim either.
struct Answer {
  std::string status;
  std::vector<std::int64_t> teeth;  ///< S, P1, P2; empty if none.
};

/// From {"status": ..., "teeth": [S, P1, P2]}.
Answer read_answer(const nlohmann::json& json);

/// "right", or what is wrong with the answer. One of several equally good designs is right.
std::string verdict(const Answer& answer, const oracles::Enumeration& truth);
std::string verdict(const gearbox::Problem& problem, const Answer& answer);

}  // namespace torquewright::bench
