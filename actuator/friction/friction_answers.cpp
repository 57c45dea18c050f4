// SPDX-License-Identifier: Apache-2.0
// The drive's law: docs/derivations/motor_region.md eq. (12).
#include "actuator/friction/friction_answers.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::actuator {

FrictionAnswers::FrictionAnswers(const Actuator& whole, const OperatingConditions& conditions,
                                 const JointFriction& friction, DryFriction dry)
    : whole_(whole),
      friction_(friction),
      dry_(dry),
      temperature_K_(winding_temperature_K(whole, conditions)),
      region_(whole, conditions) {}

double FrictionAnswers::joint_Nm(double speed_rad_s, double direction) const {
  double dry_Nm = friction_.coulomb_Nm;
  if (speed_rad_s == 0.0 && dry_ == DryFriction::kBreakaway) dry_Nm = friction_.breakaway_Nm;
  if (speed_rad_s == 0.0 && dry_ == DryFriction::kSmoothed) dry_Nm = 0.0;
  return dry_Nm * direction + friction_.viscous_Nm_s_rad * speed_rad_s;
}

double FrictionAnswers::simulated_Nm(double motor_Nm, double speed_rad_s, double direction) const {
  if (dry_ != DryFriction::kComposed) return motor_Nm - joint_Nm(speed_rad_s, direction);
  if (speed_rad_s == 0.0) {  // smoothed: the mean of both ways
    return 0.5 * (after_mesh_Nm(whole_, motor_Nm, 1.0) + after_mesh_Nm(whole_, motor_Nm, -1.0));
  }
  const double own_Nm = sliding_friction_Nm(whole_, speed_rad_s, direction, temperature_K_);
  const double limit_Nm = whole_.transmission.peak_torque_Nm;
  return std::clamp(after_mesh_Nm(whole_, motor_Nm - own_Nm * direction, direction), -limit_Nm,
                    limit_Nm);
}

Span FrictionAnswers::given_Nm(double motor_Nm, double speed_rad_s, double direction) const {
  const Span side = motor_side_torque_Nm(whole_, speed_rad_s, direction, temperature_K_);
  const double slipped_Nm = presliding_level_Nm(whole_, direction, temperature_K_) * direction;
  const auto through = [&](double side_Nm) {
    return after_mesh_Nm(whole_, motor_Nm + side_Nm - slipped_Nm, direction);
  };
  const double least_Nm = through(side.least);
  const double greatest_Nm = through(side.greatest);
  return {least_Nm + output_ripple_Nm(whole_, least_Nm).least,
          greatest_Nm + output_ripple_Nm(whole_, greatest_Nm).greatest};
}

/// A bound of the region less the friction that no region holds.
double FrictionAnswers::slipped_Nm(double region_Nm, double speed_rad_s) const {
  const double direction = std::copysign(1.0, speed_rad_s);
  const double level_Nm = presliding_level_Nm(whole_, direction, temperature_K_);
  if (level_Nm == 0.0) return region_Nm;
  const double before_Nm = before_mesh_Nm(whole_, region_Nm, direction) - level_Nm * direction;
  return after_mesh_Nm(whole_, before_Nm, direction);
}

JointRange FrictionAnswers::region(double speed_rad_s) const {
  JointRange range = region_.at(speed_rad_s);
  if (range.is_empty || speed_rad_s == 0.0) return range;
  range.least.torque_Nm = slipped_Nm(range.least.torque_Nm, speed_rad_s);
  range.greatest.torque_Nm = slipped_Nm(range.greatest.torque_Nm, speed_rad_s);
  return range;
}

}  // namespace torquewright::actuator
