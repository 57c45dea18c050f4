// SPDX-License-Identifier: Apache-2.0
#include "src/commands/planning/hopper_flip_robust_json.hpp"

#include <nlohmann/json.hpp>

namespace torquewright::cli {
namespace {

using nlohmann::ordered_json;

ordered_json counts_json(const hopper::TrialCounts& counts) {
  return {{"succeeded", counts.succeeded}, {"trials", counts.done()}};
}

}  // namespace

ordered_json robust_json(const RobustChoice& robust) {
  ordered_json list = ordered_json::array();
  for (const hopper::TriedReserve& one : robust.choice.tried) {
    list.push_back({{"reserve", one.reserve},
                    {"status", name_of(one.result.status)},
                    {"objective", one.trials ? ordered_json(one.result.objective) : nullptr},
                    {"trials", one.trials ? counts_json(*one.trials) : nullptr}});
  }
  const auto& chosen = robust.choice.chosen;
  return {{"tried", list},
          {"chosen", chosen ? ordered_json(robust.choice.tried[*chosen].reserve) : nullptr},
          {"fresh_seed", robust.fresh_seed},
          {"fresh", chosen ? counts_json(robust.fresh) : nullptr},
          {"fresh_of_least",
           robust.fresh_least.done() > 0 ? counts_json(robust.fresh_least) : nullptr}};
}

}  // namespace torquewright::cli
