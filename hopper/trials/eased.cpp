// SPDX-License-Identifier: Apache-2.0
#include "hopper/trials/eased.hpp"

namespace torquewright::hopper {
namespace {

/// Shrinks ranges towards a value.
class Shrinking {
 public:
  explicit Shrinking(double share) : share_(share) {}

  void range(Range& range, double towards) const {
    range.least = towards + share_ * (range.least - towards);
    range.greatest = towards + share_ * (range.greatest - towards);
  }
  void range(std::optional<Range>& one, double towards) const {
    if (one) range(*one, towards);
  }
  void ranges(std::vector<NamedRange>& all, double towards) const {
    for (NamedRange& one : all) range(one.range, towards);
  }

 private:
  double share_;
};

}  // namespace

Randomisation eased(Randomisation randomisation, const Robot& robot, double share) {
  if (share == 1.0) return randomisation;
  const Shrinking shrink(share);
  shrink.range(randomisation.total_mass_factor, 1.0);
  shrink.ranges(randomisation.body_mass_factor, 1.0);
  shrink.ranges(randomisation.body_inertia_factor, 1.0);
  for (ShiftRange& shift : randomisation.center_of_mass_shift_m) {
    shrink.range(shift.of_bodies.range, 0.0);
  }
  shrink.ranges(randomisation.controller_gain_factor, 1.0);
  shrink.ranges(randomisation.motor_strength_factor, 1.0);
  shrink.ranges(randomisation.further_friction_Nm, 0.0);
  if (!robot.contacts.empty()) {
    const ContactPoint& contact = robot.contacts.front();
    shrink.range(randomisation.friction_coefficient, contact.friction_coefficient);
    shrink.range(randomisation.restitution, contact.restitution);
  }
  shrink.range(randomisation.ground_height_m, 0.0);
  shrink.range(randomisation.latency_s, 0.0);
  SensorNoiseLevels& noise = randomisation.noise;
  for (double* level :
       {&noise.gravity_direction, &noise.base_rate_rad_s, &noise.base_position_m,
        &noise.base_velocity_m_s, &noise.joint_position_rad, &noise.joint_velocity_rad_s}) {
    *level *= share;
  }
  return randomisation;
}

}  // namespace torquewright::hopper
