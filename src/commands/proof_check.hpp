// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "gearbox/problem.hpp"

namespace torquewright::cli {

struct ProofCheck {
  bool is_accepted = false;
  bool is_undecided = false;    ///< A valid proof of a bound, with boxes left open.
  std::string text;             ///< For the user, with every fault.
  nlohmann::ordered_json json;  ///< The same for programs.
};

/// Checks the proof of a result, and what it says beside its proof against a fresh evaluation.
ProofCheck check_proof(const gearbox::Problem& problem, const nlohmann::json& result);

}  // namespace torquewright::cli
