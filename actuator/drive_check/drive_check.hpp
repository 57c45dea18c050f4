// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "actuator/drive_check/interpretation_check.hpp"
#include "actuator/drive_check/left_out_sizes.hpp"
#include "actuator/drive_check/trace.hpp"

namespace torquewright::actuator {

/// An actuator with its part of a trajectory.
struct CheckedDrive {
  std::string name;  ///< Name of its joint in the trajectory, or of its row in a Jacobian.
  const Actuator* actuator = nullptr;
  OperatingConditions conditions;
};

/// How a drive's samples are read.
struct DriveOptions {
  bool has_torque = true;
  InertiaConvention inertia = InertiaConvention::kUnstated;
  std::size_t runs = 1;
  double pause_s = 0.0;
  bool keep_trace = false;
  bool only_verdict = false;  ///< Leaves out the speed margin.
  Part part = Part::kCheck;   ///< kRegion: the inertia of effects is in none of the accelerations.
};

/// Checks the samples of one actuator, in constant memory.
class DriveCheck {
 public:
  DriveCheck(const CheckedDrive& drive, const DriveOptions& options);
  DriveCheck(const DriveCheck&) = delete;
  DriveCheck& operator=(const DriveCheck&) = delete;

  /// Holds the bus at this voltage from the next sample on, whatever power the drive takes.
  void set_bus_voltage_V(double voltage_V);

  /// Adds a sample. `position_rad` is the angle of the actuator's output; empty where it is
  /// unknown.
  void add(double time_s, std::optional<double> position_rad, double speed_rad_s, double torque_Nm,
           double acceleration_rad_s2);

  DriveReport finish() const;
  std::vector<TracePoint> trace() const { return trace_.points(); }

 private:
  void note_speed(double time_s, double speed_rad_s);

  std::string name_;
  DriveOptions options_;
  OperatingConditions conditions_;
  CheckBasis basis_;
  std::shared_ptr<const HeldRegion> held_;  ///< Null while the drive is on its own supply.
  double armature_kg_m2_;
  InterpretationCheck interpretation_;
  std::optional<InterpretationCheck> with_inertia_;
  LeftOutSizes left_out_;
  DriveReport report_;
  Trace trace_;
};

}  // namespace torquewright::actuator
