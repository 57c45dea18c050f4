// SPDX-License-Identifier: Apache-2.0
#include "actuator/region/joint_region.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/region/gear_losses.hpp"

namespace torquewright::actuator {
namespace {

double signed_current_A(const Actuator& actuator, const Current& current) {
  return std::copysign(current.amplitude_A(), current.q_A) /
         phase_amperes_per_ampere(actuator.motor.torque_constant_convention);
}

JointBound at_rotor(const Actuator& actuator, const MotorBound& bound) {
  return {bound.torque_Nm, signed_current_A(actuator, bound.current), bound.bus_power_W,
          bound.limiter};
}

/// How torque at the rotor becomes torque on the load at one speed and direction of the joint.
class Path {
 public:
  Path(const Actuator& actuator, double speed_rad_s, double direction, double temperature_K)
      : actuator_(actuator),
        direction_(direction),
        side_Nm_(motor_side_torque_Nm(actuator, speed_rad_s, direction, temperature_K)) {}

  /// The most that is there at every angle.
  double greatest_Nm(double motor_Nm) const {
    const double mesh_Nm =
        after_mesh_Nm(actuator_, ratio() * motor_Nm + side_Nm_.least, direction_);
    return mesh_Nm + output_ripple_Nm(actuator_, mesh_Nm).least;
  }

  double least_Nm(double motor_Nm) const {
    const double mesh_Nm =
        after_mesh_Nm(actuator_, ratio() * motor_Nm + side_Nm_.greatest, direction_);
    return mesh_Nm + output_ripple_Nm(actuator_, mesh_Nm).greatest;
  }

  /// Rotor torque that yields the joint torque at its greatest (ripple, at worst, neglected: the
  /// gear's limit is on what its teeth carry).
  double motor_Nm(double joint_Nm, bool of_greatest) const {
    const double side_Nm = of_greatest ? side_Nm_.least : side_Nm_.greatest;
    return (before_mesh_Nm(actuator_, joint_Nm, direction_) - side_Nm) / ratio();
  }

 private:
  double ratio() const { return actuator_.transmission.ratio; }

  const Actuator& actuator_;
  double direction_;
  Span side_Nm_;
};

void unite(JointRange& range, const JointRange& other) {
  if (other.is_empty) return;
  if (range.is_empty) {
    range = other;
    return;
  }
  if (other.least.torque_Nm < range.least.torque_Nm) range.least = other.least;
  if (other.greatest.torque_Nm > range.greatest.torque_Nm) range.greatest = other.greatest;
}

/// From what the motor can do at ratio times that speed.
JointRange range_at_joint(const Actuator& actuator, const PhaseModel& model, double temperature_K,
                          double speed_rad_s, double direction, MotorRange motor) {
  const double ratio = actuator.transmission.ratio;
  const double motor_rad_s = ratio * speed_rad_s;
  JointRange range{motor.is_empty, motor.why_empty, {}, {}, {}};
  const Path path(actuator, speed_rad_s, direction, temperature_K);
  if (motor.plugging) {
    const double one_Nm = path.greatest_Nm(motor.plugging->least_Nm);
    const double other_Nm = path.greatest_Nm(motor.plugging->greatest_Nm);
    range.plugging = {std::min(one_Nm, other_Nm), std::max(one_Nm, other_Nm)};
  }
  if (motor.is_empty) return range;
  // A negative ratio turns the rotor the other way: its greatest torque is the joint's least.
  if (ratio < 0.0) std::swap(motor.least, motor.greatest);
  range.least = at_rotor(actuator, motor.least);
  range.greatest = at_rotor(actuator, motor.greatest);
  range.least.torque_Nm = path.least_Nm(motor.least.torque_Nm);
  range.greatest.torque_Nm = path.greatest_Nm(motor.greatest.torque_Nm);

  const double gear_Nm = actuator.transmission.peak_torque_Nm;
  const auto limit_by_gear = [&](JointBound& bound, double limit_Nm, bool of_greatest) {
    const double motor_Nm = std::clamp(path.motor_Nm(limit_Nm, of_greatest),
                                       std::min(motor.least.torque_Nm, motor.greatest.torque_Nm),
                                       std::max(motor.least.torque_Nm, motor.greatest.torque_Nm));
    bound = at_rotor(actuator, motor_point(model, motor_Nm, motor_rad_s, Limiter::kGear));
    bound.torque_Nm = limit_Nm;
  };
  if (range.greatest.torque_Nm > gear_Nm) limit_by_gear(range.greatest, gear_Nm, true);
  if (range.least.torque_Nm < -gear_Nm) limit_by_gear(range.least, -gear_Nm, false);
  if (range.least.torque_Nm > range.greatest.torque_Nm) {
    range.is_empty = true;
    const bool by_gear = range.least.torque_Nm > gear_Nm || range.greatest.torque_Nm < -gear_Nm;
    range.why_empty = by_gear ? Limiter::kGear : range.greatest.limiter;
  }
  return range;
}

/// A curve may jump at rest, where a direction is that of a speed which is next to none.
double just_moving(const PhaseModel& model, double speed_rad_s, double direction) {
  constexpr double kNextToNone_rad_s = 1e-100;
  const bool may_jump = model.envelope && speed_rad_s == 0.0;
  return may_jump ? std::copysign(kNextToNone_rad_s, direction) : speed_rad_s;
}

/// At rest the union of both directions.
template <typename RangeTowards>
JointRange at_any_speed(const RangeTowards& range_towards, double speed_rad_s) {
  if (speed_rad_s != 0.0) return range_towards(std::copysign(1.0, speed_rad_s));
  JointRange range = range_towards(-1.0);
  unite(range, range_towards(1.0));
  return range;
}

}  // namespace

Region::Region(const Actuator& actuator, const OperatingConditions& conditions, Side side)
    : actuator_(actuator),
      temperature_K_(actuator::winding_temperature_K(actuator, conditions)),
      model_(phase_model_at(actuator, conditions)),
      side_(side) {
  const double no_load_rad_s = no_load_speed_rad_s(model_);
  const double motor_rad_s =
      actuator::greatest_speed_rad_s(model_, kSpeedsLookedAt * no_load_rad_s);
  greatest_speed_rad_s_ =
      side == Side::kMotor ? motor_rad_s : motor_rad_s / std::abs(actuator.transmission.ratio);
}

MotorRange Region::motor_at(double speed_rad_s) const {
  const double ratio = side_ == Side::kMotor ? 1.0 : actuator_.transmission.ratio;
  return motor_range(model_, ratio * speed_rad_s);
}

JointRange Region::at(double speed_rad_s, double direction, const MotorRange& motor) const {
  return side_ == Side::kMotor
             ? at_motor(motor)
             : range_at_joint(actuator_, model_, temperature_K_, speed_rad_s, direction, motor);
}

JointRange Region::at(double speed_rad_s, double direction) const {
  return at(speed_rad_s, direction, motor_at(just_moving(model_, speed_rad_s, direction)));
}

JointRange Region::at(double speed_rad_s) const {
  return at_any_speed([&](double direction) { return at(speed_rad_s, direction); }, speed_rad_s);
}

JointRange Region::at_motor(const MotorRange& motor) const {
  JointRange range{motor.is_empty, motor.why_empty, {}, {}, motor.plugging};
  if (motor.is_empty) return range;
  range.least = at_rotor(actuator_, motor.least);
  range.greatest = at_rotor(actuator_, motor.greatest);
  return range;
}

JointRange range_at(const Actuator& actuator, const OperatingConditions& conditions,
                    double speed_rad_s) {
  const PhaseModel model = phase_model_at(actuator, conditions);
  const double temperature_K = winding_temperature_K(actuator, conditions);
  return at_any_speed(
      [&](double direction) {
        const double moving_rad_s = just_moving(model, speed_rad_s, direction);
        const MotorRange motor = motor_range(model, actuator.transmission.ratio * moving_rad_s);
        return range_at_joint(actuator, model, temperature_K, speed_rad_s, direction, motor);
      },
      speed_rad_s);
}

}  // namespace torquewright::actuator
