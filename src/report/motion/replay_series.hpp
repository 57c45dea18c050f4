// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/check/series.hpp"
#include "src/report/motion/replay_page.hpp"
#include "src/report/parts/skeleton.hpp"
#include "src/report/robot/shown_violations.hpp"

namespace torquewright::report {

/// A run by time as its page shows it, a row a control instant.
struct ShownRun {
  /// The series of the run; beside it pitch_rad, height_m (of the centre of mass) and the same with
  /// planned_ before, ground_up_N and ground_forward_N (means over the control interval),
  /// in_flight, and for each drive outside_column().
  hopper::Series series;
  Skeleton skeleton;
  std::vector<Pose> poses;
  std::vector<Pose> planned;
  std::vector<ShownViolation> violations;  ///< Torque that was cut off, and a fall.
  std::vector<Interval> flights;           ///< Losses of contact too short to matter left out.
};
/// Requires a record with rows.
ShownRun shown_run(const ReplayPage& page);

/// The rule of a violation whose drive could not give what was wanted.
extern const char* const kCutOff;

/// The force that all but a fiftieth stay below, in N: a touch-down's, of one interval, would leave
/// no room for the others. 0 of none.
double usual_greatest_N(std::vector<double> forces_N);

/// The names of a robot's drives in their order.
std::vector<std::string> drive_names_of(const hopper::Robot& robot);

}  // namespace torquewright::report
