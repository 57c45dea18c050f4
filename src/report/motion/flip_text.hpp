// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hopper/planning/search/plan.hpp"

namespace torquewright::report {

/// What a plan came to, and what it was asked for.
struct FlipAnswer {
  const hopper::Robot& robot;
  const hopper::PlanOptions& options;
  const hopper::PlanResult& result;
  std::vector<std::string> next;  ///< What to do with it, a line each.
  std::string chosen_reserve;     ///< How the reserve was chosen, in lines; empty: it was stated.
  bool has_seconds = false;       ///< Whether seconds are stated: then two runs differ in bytes.
};

/// What `hopper flip` says: the verdict with its sentence, phases, flight, the least margin of each
/// rule, loads, what binds where, rounds, and what comes next.
std::string flip_text(const FlipAnswer& answer);

}  // namespace torquewright::report
