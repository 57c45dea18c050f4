// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "actuator/region/motor_region.hpp"
#include "actuator/region/operating_conditions.hpp"

namespace torquewright::actuator {

/// One end of the region at the joint.
struct JointBound {
  double torque_Nm = 0.0;  ///< On the load.
  double current_A = 0.0;  ///< In the document's convention, signed like the q current.
  double bus_power_W = 0.0;
  Limiter limiter = Limiter::kCurrent;
};

/// The torques that an actuator can have on its load at one speed.
struct JointRange {
  bool is_empty = false;
  Limiter why_empty = Limiter::kVoltage;
  JointBound least;
  JointBound greatest;
  std::optional<MotorRange::Plugging> plugging;  ///< At the joint, after all losses.
};

/// Which side of the gearbox speeds and torques are of. The motor's side is the rotor: before any
/// friction.
enum class Side { kJoint, kMotor };

/// The region of an actuator under conditions: asked at a speed, as often as need be. One object
/// serves any number of threads. docs/derivations/motor_region.md sections 4 and 5.
class Region {
 public:
  /// Requires that there are no objections to the conditions.
  Region(const Actuator& actuator, const OperatingConditions& conditions, Side side = Side::kJoint);

  /// The torques at that speed; `direction` (-1, 1) is the sign of the motion where the speed is 0.
  JointRange at(double speed_rad_s, double direction) const;

  /// Returns the range where what the motor can do there (motor_at) is known already.
  JointRange at(double speed_rad_s, double direction, const MotorRange& motor) const;
  MotorRange motor_at(double speed_rad_s) const;

  /// Returns the range at any speed; at rest the union of both directions.
  JointRange at(double speed_rad_s) const;

  /// The region is empty beyond these speeds (or goes on past the last that is looked at, which is
  /// kSpeedsLookedAt times the no-load speed).
  double greatest_speed_rad_s() const { return greatest_speed_rad_s_; }
  static constexpr double kSpeedsLookedAt = 4.0;

  const PhaseModel& model() const { return model_; }
  Side side() const { return side_; }

 private:
  JointRange at_motor(const MotorRange& motor) const;

  Actuator actuator_;
  double temperature_K_;
  PhaseModel model_;
  Side side_;
  double greatest_speed_rad_s_ = 0.0;
};

/// Region::at of that speed, at the joint, where one is asked and not where the region ends, which
/// takes as long as dozens of speeds.
JointRange range_at(const Actuator& actuator, const OperatingConditions& conditions,
                    double speed_rad_s);

}  // namespace torquewright::actuator
