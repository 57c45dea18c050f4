// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hopper/replay/replay.hpp"

namespace torquewright::hopper {

/// Names as options and documents have them.
std::string_view name_of(EngineKind engine);
std::string_view name_of(ControllerKind controller);
std::string_view name_of(DriveLimits limits);
std::string_view name_of(ImpactHandling handling);

/// All that a replay answers.
struct ReplayReport {
  ReplayOptions options;
  ReplayResult result;           ///< Of the run as documented.
  std::vector<SweptStep> sweep;  ///< Empty where none was asked for.
};

}  // namespace torquewright::hopper
