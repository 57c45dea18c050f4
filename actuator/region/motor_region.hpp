// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "actuator/motor/phase_model.hpp"

namespace torquewright::actuator {

/// One end of what the motor can do at a speed.
struct MotorBound {
  double torque_Nm = 0.0;
  Current current;
  double bus_power_W = 0.0;
  Limiter limiter = Limiter::kCurrent;
};

/// The torques of the motor at a speed: the connected set that contains zero current, or, beyond
/// no-load speed, lies nearest to it. Empty ranges say why.
struct MotorRange {
  bool is_empty = false;
  Limiter why_empty = Limiter::kVoltage;
  MotorBound least;
  MotorBound greatest;
  /// Braking torque past the gap that the regeneration limit cuts out, where power flows from the
  /// bus again (plugging): apart, since a drive cannot get there without passing the gap.
  struct Plugging {
    double least_Nm;
    double greatest_Nm;
  };
  std::optional<Plugging> plugging;
};

/// Returns the torques that the motor can make at a speed, at the rotor, before any friction.
/// docs/derivations/motor_region.md section 4.
MotorRange motor_range(const PhaseModel& model, double speed_rad_s);

/// The range at the opposite speed: a motor is the same both ways round.
MotorRange mirrored(const MotorRange& range);

/// The bound's numbers for a torque inside the range, at the current that the drive chooses.
MotorBound motor_point(const PhaseModel& model, double torque_Nm, double speed_rad_s,
                       Limiter limiter);

/// Speed up to which the range is not empty, or `limit_rad_s` if it does not end before.
double greatest_speed_rad_s(const PhaseModel& model, double limit_rad_s);

/// Speed at which the back-EMF takes up the whole voltage without current. Infinite without EMF.
double no_load_speed_rad_s(const PhaseModel& model);

}  // namespace torquewright::actuator
