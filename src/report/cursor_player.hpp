// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/report/hopper_charts.hpp"

namespace torquewright::report {

/// The controls of the time cursor: buttons, and the slider over a track that shows flights,
/// impacts and violations. Hidden until the page's script runs.
std::string cursor_player(const ChartSource& source);

/// What stands at the cursor, drive by drive; hidden like the player.
std::string cursor_values(const ChartSource& source);

}  // namespace torquewright::report
