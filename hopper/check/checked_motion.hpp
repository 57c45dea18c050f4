// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/check/report.hpp"
#include "actuator/region/operating_conditions.hpp"
#include "hopper/check/demand.hpp"

namespace torquewright::hopper {

using actuator::Finding;

/// Which torques the actuators are held against.
enum class TorqueSource {
  kBest,  ///< The file's where it has all, else those of the dynamics.
  kFile,
  kDynamics,
};

/// Columns that may belong to the row before (hopper/check/late_columns.hpp).
enum class LateRows {
  kFind,
  kKeep,   ///< All are as they stand.
  kShift,  ///< All but positions and velocities belong to the row before.
};

struct CheckOptions {
  ContactRule contact;
  double residual_share = 0.1;      ///< Of the weight (and weight times size): more is no motion.
  double residual_window_s = 0.01;  ///< Over which the residual is averaged.
  double shortest_flight_s = 0.01;  ///< A shorter loss of contact is chatter.
  double load_window_s = 0.01;      ///< Over which a transmission's load is.
  TorqueSource torques = TorqueSource::kBest;
  LateRows late_columns = LateRows::kFind;
  actuator::OperatingConditions conditions;
  std::size_t runs = 1;
  double pause_s = 0.0;
  bool keep_traces = false;
  std::function<void(double share)> on_progress = {};  ///< May be empty.
};

/// A motion and what it asks for: what every rule looks at.
struct CheckedMotion {
  const Robot& robot;
  const CheckOptions& options;
  const Motion& motion;
  const ContactSchedule& contacts;
  const Demand& demand;
};

}  // namespace torquewright::hopper
