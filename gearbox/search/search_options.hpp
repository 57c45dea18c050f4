// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <limits>

#include "optimization/discrete/branch_and_bound.hpp"
#include "optimization/expressions/box.hpp"

namespace torquewright::gearbox {

struct DesignSearchOptions {
  std::size_t top = 1;
  optimization::RelaxationUse relaxation = optimization::RelaxationUse::kAuto;
  std::int64_t max_nodes = std::numeric_limits<std::int64_t>::max();
  std::function<bool()> should_stop = [] { return false; };
  /// Cost and bound are the objective as the user reads it.
  std::function<void(const optimization::Progress&)> report = [](const optimization::Progress&) {};
  /// Called for each box that is closed, for tests; see optimization::SearchOptions.
  std::function<void(std::size_t, const optimization::Box&, double)> on_close =
      [](std::size_t, const optimization::Box&, double) {};
};

}  // namespace torquewright::gearbox
