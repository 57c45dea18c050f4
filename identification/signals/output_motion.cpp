// SPDX-License-Identifier: Apache-2.0
#include "identification/signals/output_motion.hpp"

#include "identification/signals/signal.hpp"

namespace torquewright::identification {
namespace {

std::vector<double> divided(std::vector<double> values, double by) {
  for (double& value : values) value /= by;
  return values;
}

/// Before the filter. Empty where no position was logged.
std::vector<double> read_position(ChannelGrid& grid, double ratio) {
  for (const Quantity quantity : {Quantity::kOutputPosition, Quantity::kLinearPosition}) {
    if (grid.has(quantity)) return grid.read_unfiltered(quantity);
  }
  if (!grid.has(Quantity::kMotorPosition)) return {};
  return divided(grid.read_unfiltered(Quantity::kMotorPosition), ratio);
}

std::vector<double> read_velocity(ChannelGrid& grid, double ratio) {
  if (grid.has(Quantity::kOutputVelocity)) return grid.read(Quantity::kOutputVelocity);
  if (grid.has(Quantity::kLinearVelocity)) return grid.read(Quantity::kLinearVelocity);
  return divided(grid.read(Quantity::kMotorVelocity), ratio);
}

/// By the trapezoidal rule. Only differences of the angle mean something then.
std::vector<double> integrated(const std::vector<double>& velocity, double step_s) {
  std::vector<double> position(velocity.size(), 0.0);
  for (std::size_t i = 1; i < velocity.size(); ++i) {
    position[i] = position[i - 1] + 0.5 * (velocity[i - 1] + velocity[i]) * step_s;
  }
  return position;
}

}  // namespace

JointMotion read_motion(ChannelGrid& grid, const actuator::Actuator& actuator,
                        std::vector<double>* unfiltered_rad) {
  const double ratio = actuator.transmission.ratio;
  JointMotion motion;
  motion.position_rad = read_position(grid, ratio);
  if (unfiltered_rad != nullptr) *unfiltered_rad = motion.position_rad;
  if (!motion.position_rad.empty()) motion.position_rad = grid.filtered(motion.position_rad);
  if (grid.is_map()) {
    motion.velocity_rad_s.assign(grid.count(), 0.0);
    motion.acceleration_rad_s2.assign(grid.count(), 0.0);
    motion.position_rad.resize(grid.count(), 0.0);
    return motion;
  }
  if (motion.position_rad.empty()) {
    motion.velocity_rad_s = read_velocity(grid, ratio);
    motion.position_rad = integrated(motion.velocity_rad_s, grid.step_s());
  } else {
    motion.velocity_rad_s = derivative(motion.position_rad, grid.step_s());
  }
  motion.acceleration_rad_s2 = derivative(motion.velocity_rad_s, grid.step_s());
  return motion;
}

}  // namespace torquewright::identification
