// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hopper/check/checked_motion.hpp"
#include "hopper/replay/verdict.hpp"

namespace torquewright::hopper {

/// What one drive did in a run.
struct DriveReplay {
  std::string name;
  double clipped_share = 0.0;  ///< Of the control instants: its torque was cut off.
  double peak_cut_off_Nm = 0.0;
  double cut_off_time_s = 0.0;           ///< Of the greatest.
  double peak_torque_Nm = 0.0;           ///< That acted, in size.
  double peak_tracking_error_rad = 0.0;  ///< Of its output's angle.
  double error_time_s = 0.0;
  std::optional<double> peak_winding_K;  ///< None without thermal data.
  std::optional<double> winding_limit_K;
};

/// What the ground gave at touch-down. The impulse depends little on the engine's step, the force
/// is a mean over a stated time.
struct TouchDownLoad {
  double window_s = 0.0;
  Eigen::Vector3d impulse_N_s = Eigen::Vector3d::Zero();  ///< Of all points over the window.
  double force_window_s = 0.0;
  double peak_force_N = 0.0;  ///< Greatest mean over that time, in size, within the window.
};

struct ReplayResult {
  ReplayOutcome outcome;
  std::vector<DriveReplay> drives;
  std::vector<TransmissionLoad> transmission_loads;
  std::vector<ContactLoad> contact_loads;
  std::optional<TouchDownLoad> touch_down_load;
  std::optional<double> least_bus_V;  ///< Of the drives with a winding.
  double least_bus_s = 0.0;
  double greatest_power_W = 0.0;
  std::vector<Finding> findings;
};

/// What a run comes to. `robot` is that of the run; loads are means over `load_window_s`.
ReplayResult result_of(const Robot& robot, const Reference& reference, const Record& record,
                       const StandingRule& standing, double load_window_s);

}  // namespace torquewright::hopper
