// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "src/report/robot/cursor_json.hpp"
#include "src/report/robot/cursor_player.hpp"
#include "src/report/robot/hopper_charts.hpp"

namespace torquewright::report {

/// What the cursor of a whole-body check's page moves over. `figure` is null where there is none.
CursorSource hopper_cursor(const ChartSource& source, const std::vector<Eigen::Index>& samples,
                           const MovingFigure* figure, double begin_s);

/// What the track under its slider shows.
Track hopper_track(const ChartSource& source);

/// What stands at the cursor, drive by drive; hidden like the player.
std::string hopper_values(const ChartSource& source);

}  // namespace torquewright::report
