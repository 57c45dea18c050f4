// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "hopper/planning/search/reserve_search.hpp"

namespace torquewright::cli {

/// How a reserve was chosen by trials.
struct RobustChoice {
  hopper::ReserveChoice choice;
  hopper::TrialCounts fresh;        ///< Of the chosen plan, on draws that chose nothing.
  hopper::TrialCounts fresh_least;  ///< Of the least reserve's plan on the same; of none: no plan.
  std::uint64_t fresh_seed = 0;
};

}  // namespace torquewright::cli
