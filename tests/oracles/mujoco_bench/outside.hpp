// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/oracles/mujoco_bench/rigs.hpp"

namespace torquewright::oracles::mujoco_bench {

/// Something real that no effect of the table describes.
struct Outside {
  std::string kind;
  Demand demand;
  /// Along which an honest tool could show that something is left.
  std::vector<std::string> coordinates;
  Effect (*make)(double scale, const Situation& it, Draws draws);
};

const std::vector<Outside>& outside_kinds();

}  // namespace torquewright::oracles::mujoco_bench
