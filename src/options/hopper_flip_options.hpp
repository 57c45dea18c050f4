// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "src/command_line/command_line.hpp"
#include "src/options/hopper_flip_request.hpp"

namespace torquewright::cli {

/// Where in the help an option stands: between the groups are those that other commands have too.
enum class FlipGroup {
  kTask,
  kDurations,
  kMargins,
  kSearch,
  kExplanation,
  kLoads,
  kWarm,
  kContacts,
  kFiles
};

/// What an option states, for who writes it down.
using StatedValue = std::variant<bool, int, double, std::uint64_t, std::string,
                                 std::vector<std::string>, std::vector<double>>;

/// One option of `hopper flip`: all that the command line, its help, a result and a sweep know of
/// it. What it does to a plan stands where the plan reads its value.
struct HopperFlipOption {
  FlipGroup group;
  std::string names;  ///< "-o,--output".
  std::string key;    ///< Under "options" of a result, where it is not the default; empty: never.
  bool is_of_one_plan = false;  ///< A sweep, which is of several, refuses it.
  std::function<void(command_line::Command& command, HopperFlipRequest& request)> declare;
  /// Its value, where that is not the default.
  std::function<std::optional<StatedValue>(const HopperFlipRequest& request)> stated;
};

/// In the order in which results state them. Robot, conditions, columns and axes of a sweep, which
/// other commands have too, are not among them.
const std::vector<HopperFlipOption>& hopper_flip_options();

/// Adds everything that `hopper flip` takes: its own options and those of other commands too.
void add_hopper_flip_options(command_line::Command& command, HopperFlipRequest& request);

}  // namespace torquewright::cli
