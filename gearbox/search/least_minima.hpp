// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "gearbox/search/ranking.hpp"

namespace torquewright::gearbox {

/// A design that beats the one in question unless minima or clearance exclude it.
struct BetterDesign {
  std::vector<std::int64_t> free_teeth;
  double clearance_rad;
};

/// For which alpha_min and minima a design is the optimum: every better design must have fewer
/// teeth than a minimum in one gear, or less clearance than alpha_min. Ranges of alpha_min with the
/// same answer are one range.
std::vector<OptimalWhen> optimal_when(const std::vector<std::int64_t>& free_teeth,
                                      double clearance_rad, std::vector<BetterDesign> better);

}  // namespace torquewright::gearbox
