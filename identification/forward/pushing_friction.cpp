// SPDX-License-Identifier: Apache-2.0
#include "identification/forward/pushing_friction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "actuator/region/torque_at.hpp"

namespace torquewright::identification {
namespace {

constexpr double kAngles = 16.0;     ///< Of the fastest wave.
constexpr double kFitsError = 0.25;  ///< Of the strongest wave.

}  // namespace

bool friction_pushes(const actuator::Actuator& actuator, double speed_rad_s) {
  double fastest = 0.0, strongest_Nm = 0.0;
  for (const actuator::Effect& effect : actuator.effects) {
    if (effect.kind->acts != actuator::Acts::kDrag) continue;
    for (const actuator::Harmonic& wave : effect.harmonics) {
      fastest = std::max(fastest, wave.order);
      strongest_Nm = std::max(strongest_Nm, wave.amplitude);
    }
  }
  if (strongest_Nm == 0.0) return false;
  actuator::Instant at;
  at.speed_rad_s = speed_rad_s;
  at.direction = 1.0;
  double least_Nm = INFINITY;
  for (double k = 0.0; k < kAngles * fastest; ++k) {
    at.output_angle_rad = 2.0 * std::numbers::pi * k / (kAngles * fastest);
    least_Nm = std::min(least_Nm, -actuator::drag_Nm(actuator, at));
  }
  return least_Nm < -kFitsError * strongest_Nm;
}

}  // namespace torquewright::identification
