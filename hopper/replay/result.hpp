// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hopper/demand/checked_motion.hpp"
#include "hopper/tracking/control_account.hpp"
#include "hopper/verdict/goal.hpp"
#include "hopper/verdict/verdict.hpp"

namespace torquewright::hopper {

/// Result of one drive in a run.
struct DriveReplay {
  std::string name;
  bool moves_slide = false;    ///< Torques below are forces in N, angles ways in m.
  double clipped_share = 0.0;  ///< Share of the control instants at which its torque was cut off.
  double peak_cut_off_Nm = 0.0;
  double cut_off_time_s = 0.0;           ///< Time of the greatest cut.
  double peak_torque_Nm = 0.0;           ///< Greatest torque that acted, in size.
  double peak_tracking_error_rad = 0.0;  ///< Greatest error of its output's angle.
  double error_time_s = 0.0;
  /// Greatest winding temperature; none without thermal data.
  std::optional<double> peak_winding_K;
  std::optional<double> winding_limit_K;
};

/// Load from the ground at touch-down. The impulse depends little on the engine's step, the force
/// is a mean over a stated time.
struct TouchDownLoad {
  double window_s = 0.0;
  /// Impulse of all points over the window.
  Eigen::Vector3d impulse_N_s = Eigen::Vector3d::Zero();
  double force_window_s = 0.0;
  double peak_force_N = 0.0;  ///< Greatest mean over that time, in size, within the window.
};

struct ReplayResult {
  ReplayOutcome outcome;
  std::vector<DriveReplay> drives;
  std::vector<TransmissionLoad> transmission_loads;
  std::vector<ContactLoad> contact_loads;
  std::optional<TouchDownLoad> touch_down_load;
  /// Least voltage of the drives that have a winding; empty: there are none.
  std::optional<double> least_bus_V;
  double least_bus_s = 0.0;
  double greatest_power_W = 0.0;
  ControlAccount account;  ///< Of a controller that weighs tasks.
  std::vector<Finding> findings;
};

/// Returns the result of a run. `robot` is the one of the run; loads are means over
/// `load_window_s`.
ReplayResult result_of(const Robot& robot, const Reference& reference,
                       const std::vector<TimeInAir>& planned, const Record& record,
                       const VerdictRule& rule, double load_window_s);
/// The same of a run that follows no motion: nothing is said of tracking errors.
ReplayResult result_of(const Robot& robot, const Reference& ends, const Goal& goal,
                       const Record& record, const VerdictRule& rule, double load_window_s);

}  // namespace torquewright::hopper
