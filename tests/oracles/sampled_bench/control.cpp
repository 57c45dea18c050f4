// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/sampled_bench/control.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace torquewright::oracles::sampled {
namespace {

constexpr double kBandwidth_rad_s = 2.0 * std::numbers::pi * 5.0;

/// Position and speed control with what is known of the load fed forward.
double torque_asked_Nm(const Plant& plant, const Instant& now, const Target& target) {
  const double inertia = plant.moved_kg_m2();
  const double position = inertia * kBandwidth_rad_s * kBandwidth_rad_s;
  const double speed = 1.6 * inertia * kBandwidth_rad_s;
  return inertia * target.acceleration_rad_s2 +
         plant.load.gravity_Nm() * std::sin(target.angle_rad) +
         position * (target.angle_rad - now.motor_angle_rad) +
         speed * (target.speed_rad_s - now.motor_speed_rad_s);
}

}  // namespace

double command_of(const Plant& plant, const RunPlan& plan, const Instant& now,
                  const Target& target) {
  const double asked_A = plant.load.kind == LoadKind::kImposedSpeed
                             ? plan.other.at(target.run_time_s)
                             : torque_asked_Nm(plant, now, target) / plant.Nm_per_A();
  const double current_A = std::clamp(asked_A, -plant.peak_current_A, plant.peak_current_A);
  if (!plant.is_voltage_driven()) return current_A;
  const double winding_V =
      plant.resistance_ohm * current_A + plant.Nm_per_A() * now.motor_speed_rad_s;
  const double limit_V = 0.95 * now.bus_V;
  const double volts = std::clamp(winding_V, -limit_V, limit_V);
  return plant.drive == DriveKind::kDuty ? volts / now.bus_V : volts;
}

}  // namespace torquewright::oracles::sampled
