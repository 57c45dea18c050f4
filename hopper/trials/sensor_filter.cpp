// SPDX-License-Identifier: Apache-2.0
#include "hopper/trials/sensor_filter.hpp"

#include "dynamics/position_step.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

Index places_of(dynamics::BaseKind base) {
  return base == dynamics::BaseKind::kSpatial ? 3 : base == dynamics::BaseKind::kPlanar ? 2 : 0;
}

}  // namespace

SensorFilter::SensorFilter(const SensorNoiseLevels& noise, const dynamics::Tree& tree)
    : tree_(tree), correction_(tree.velocity_size()) {
  const Index places = places_of(tree.base), base = tree.base_velocity_size();
  groups_ = {
      {{0, places, noise.base_position_m, noise.base_velocity_m_s},
       {places, base - places, noise.gravity_direction, noise.base_rate_rad_s},
       {base, tree.velocity_size() - base, noise.joint_position_rad, noise.joint_velocity_rad_s}}};
  for (Group& group : groups_) group.variance = group.position_noise * group.position_noise;
}

// docs/randomisation.md, eq. (5)
double SensorFilter::Group::gain_after(double period_s) {
  const double measured = position_noise * position_noise;
  if (measured == 0.0) return 1.0;
  const double carried = variance + rate_noise * rate_noise * period_s * period_s;
  const double gain = carried / (carried + measured);
  variance = (1.0 - gain) * carried;
  return gain;
}

// docs/randomisation.md, eq. (4)
void SensorFilter::estimate(double time_s, Eigen::VectorXd& position,
                            const Eigen::VectorXd& velocity) {
  if (last_s_) {
    const double period_s = time_s - *last_s_;
    dynamics::step_position(tree_, position_, 0.5 * (velocity_ + velocity), period_s, position_);
    dynamics::position_difference(tree_, position_, position, correction_);
    for (Group& group : groups_) {
      correction_.segment(group.first, group.size) *= group.gain_after(period_s);
    }
    dynamics::step_position(tree_, position_, correction_, 1.0, position_);
    position = position_;
  }
  position_ = position;
  velocity_ = velocity;
  last_s_ = time_s;
}

}  // namespace torquewright::hopper
