// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/drive_check/report.hpp"
#include "actuator/region/operating_conditions.hpp"
#include "hopper/demand/demand.hpp"

namespace torquewright::hopper {

using actuator::Finding;

/// Source of the torques that the actuators are held against.
enum class TorqueSource {
  kBest,  ///< Torques of the file where it has all, else those of the dynamics.
  kFile,
  kDynamics,
};

/// How columns are read that may belong to the row before (hopper/check/late_columns.hpp).
enum class LateRows {
  kFind,
  kKeep,   ///< All columns belong to their own rows.
  kShift,  ///< All columns but positions and velocities belong to the row before.
};

struct CheckOptions {
  ContactRule contact;
  /// Limit of the residual as a share of the weight (and of weight times size); beyond it the
  /// motion is refused.
  double residual_share = 0.1;
  /// Greatest share of the rows that may ask for more than that limit and are left out of the
  /// verdict (hopper/check/left_out_rows.hpp); 0: one refuses the motion.
  double left_out_share = 0.01;
  double residual_window_s = 0.01;  ///< Window over which the residual is averaged.
  double shortest_flight_s = 0.01;  ///< A shorter loss of contact is chatter.
  double load_window_s = 0.01;      ///< Window over which a transmission's load is averaged.
  TorqueSource torques = TorqueSource::kBest;
  LateRows late_columns = LateRows::kFind;
  actuator::OperatingConditions conditions;
  std::size_t runs = 1;
  double pause_s = 0.0;
  bool keep_traces = false;
  /// Called with the share that is done. May be empty.
  std::function<void(double share)> on_progress = {};
};

/// A motion with everything that rules need: its demand, contacts and options.
struct CheckedMotion {
  const Robot& robot;
  const CheckOptions& options;
  const Motion& motion;
  const ContactSchedule& contacts;
  const Demand& demand;
};

}  // namespace torquewright::hopper
