// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hopper/record/load_window.hpp"
#include "hopper/tracking/control_account.hpp"
#include "hopper/tracking/reference.hpp"

namespace torquewright::hopper {

/// A robot at one control instant of a replay, and what happened since the one before.
struct RecordRow {
  double time_s = 0.0;
  Eigen::VectorXd position;
  Eigen::VectorXd velocity;
  Eigen::VectorXd wanted_Nm;   ///< Torque wanted, by drive, at its output, as the next two.
  Eigen::VectorXd torque_Nm;   ///< That acted at the end of the interval; in the first row, next.
  Eigen::VectorXd cut_off_Nm;  ///< The greatest of the interval, signed.
  Eigen::VectorXd speed_rad_s;
  Eigen::VectorXd bus_V;
  Eigen::VectorXd winding_K;
  Eigen::VectorXd impulses_N_s;  ///< (3 points x 1), sum over the interval.
  TouchingPoints touches;        ///< Points that the ground pressed on in the interval.
  double slip_m_s = 0.0;         ///< Speed of the fastest of those.
};

/// Why a run ended.
enum class RunEnd {
  kDone,     ///< Its time was over.
  kFell,     ///< A body that is no foot came to the ground.
  kStopped,  ///< The engine or the controller could not go on.
  kAsked,    ///< Someone asked it to stop.
};

/// Everything recorded in one run.
struct Record {
  std::vector<RecordRow> rows;
  DriveSteps steps;
  RunEnd end = RunEnd::kDone;
  double end_s = 0.0;
  std::string reason;  ///< Why, unless it is done.
  double step_s = 0.0;
  double control_period_s = 0.0;
  std::size_t starved_steps = 0;  ///< Number of steps in which a battery could not give the power.
  /// Charge that left each supply, in the order of drive_supplies(), less what came back, in Ah.
  std::vector<double> drawn_Ah;
  double greatest_power_W = 0.0;  ///< Greatest power of all batteries together, over all steps.
  /// Least voltage of the drives that have a winding, over all steps; empty: there are none.
  std::optional<double> least_bus_V;
  double least_bus_s = 0.0;
  ControlAccount account;  ///< The controller's own.
};

}  // namespace torquewright::hopper
