// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "actuator/drive_check/drive_check.hpp"
#include "actuator/trajectory/columns.hpp"
#include "actuator/trajectory/jacobian.hpp"
#include "actuator/trajectory/trajectory_reader.hpp"

namespace torquewright::actuator {

struct CheckRequest {
  std::filesystem::path trajectory;
  std::vector<ColumnMapping> columns;
  Window window;
  std::vector<CheckedDrive> drives;      ///< Drives, one for each joint or row of a Jacobian.
  std::vector<ParallelDrive> parallels;  ///< Each takes two of the drives, by their names.
  InertiaConvention inertia = InertiaConvention::kUnstated;
  std::size_t runs = 1;  ///< Number of runs of the motion, for the winding's temperature.
  double pause_s = 0.0;  ///< Pause after each run.
  bool keep_traces = false;
  /// Called with the share that is done. May be empty.
  std::function<void(double share)> on_progress;
};

/// Checks drives against a trajectory, which is read once, row by row, in constant memory. Requires
/// distinct names of drives, at least one, and that there are no objections to their conditions.
/// Throws io::SpecError for all that TrajectoryReader throws for, a Jacobian whose actuators are no
/// drives, whose table does not reach as far as the angles go, or which is singular there, and a
/// window without rows.
CheckReport check(const CheckRequest& request);

}  // namespace torquewright::actuator
