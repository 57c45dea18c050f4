// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "src/report/motion/replay_series.hpp"

namespace torquewright::report {

/// Charts of a run over time, each with its legend. Empty where there is nothing to draw.

/// Base and centre of mass, as planned and as they were.
/// Beside the motion that was planned, where one was.
std::string motion_charts(const ShownRun& run, bool is_planned);
/// One of torque and one of speed a drive.
std::string drive_charts(const ReplayPage& page, const ShownRun& run);
/// Bus voltages and the ground's force.
std::string supply_and_ground_charts(const ReplayPage& page, const ShownRun& run);

}  // namespace torquewright::report
