// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "src/report/robot/hopper_page.hpp"
#include "src/report/robot/shown_violations.hpp"

namespace torquewright::report {

/// What the charts of a whole-body check are drawn from.
struct ChartSource {
  const HopperPage& page;
  const hopper::Series& series;  ///< With that of the drives.
  const std::vector<ShownViolation>& violations;
};

/// The column that is 1 where a drive's torque lies outside its region; not one of the series.
std::string outside_column(const std::string& drive);
/// The columns of a drive's torque at the gears, on the side that is judged, and of the bus.
std::string gear_column(const HopperPage& page, std::size_t drive);
/// Sums over all contacts and sizes of vectors, as further columns of a series.
void add_sums(const HopperPage& page, hopper::Series& series);
/// Positions of the joints, likewise.
void add_joint_positions(const HopperPage& page, hopper::Series& series);

/// One chart a drive, each with axes of its own, and what its colours mean. Empty without drives.
std::string region_charts(const ChartSource& source);
std::string torque_charts(const ChartSource& source);
std::string gear_charts(const ChartSource& source);
/// Bus voltages, the ground's force, CAM and CAV.
std::string body_charts(const ChartSource& source);

}  // namespace torquewright::report
