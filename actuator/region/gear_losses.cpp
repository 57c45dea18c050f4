// SPDX-License-Identifier: Apache-2.0
#include "actuator/region/gear_losses.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/effects/harmonics.hpp"
#include "actuator/heat/temperature_laws.hpp"

namespace torquewright::actuator {
namespace {

void add(Span& sum, const Span& part) {
  sum.least += part.least;
  sum.greatest += part.greatest;
}

Span scaled(const HarmonicRange& range, double factor) {
  const double one = range.smallest * factor;
  const double other = range.largest * factor;
  return {std::min(one, other), std::max(one, other)};
}

/// What an effect without harmonics yields at every angle, and one with them at its worst ones.
Span over_angles(const Effect& effect, const Instant& at) {
  if (!effect.kind->has_harmonics) {
    const double torque_Nm = effect.kind->law(effect, at);
    return {torque_Nm, torque_Nm};
  }
  const double sign = effect.kind->acts == Acts::kDrag ? -at.direction : 1.0;
  return scaled(harmonic_range(effect.harmonics), sign);
}

/// Share of the torque that load-dependent friction takes: k at a torque of 1 Nm.
double load_coefficient(const Actuator& actuator, bool is_driving) {
  Instant at;
  at.direction = is_driving ? 1.0 : -1.0;
  at.load_torque_Nm = 1.0;
  double coefficient = 0.0;
  for (const Effect& effect : actuator.effects) {
    if (effect.kind->acts == Acts::kLoadFriction) {
      coefficient += std::abs(effect.kind->law(effect, at));
    }
  }
  return coefficient;
}

/// Torque after over torque before the mesh.
double mesh_factor(const Actuator& actuator, bool is_driving) {
  const Transmission& gear = actuator.transmission;
  const double k = load_coefficient(actuator, is_driving);
  if (is_driving) return gear.forward_efficiency / (1.0 + k);
  const double passed = gear.backward_efficiency * (1.0 - k);
  return passed > 0.0 ? 1.0 / passed : kUnlimited;
}

}  // namespace

Span motor_side_torque_Nm(const Actuator& actuator, double speed_rad_s, double direction,
                          double temperature_K) {
  Instant at = at_winding_temperature(actuator, temperature_K);
  at.speed_rad_s = speed_rad_s;
  at.direction = direction;
  Span drag;
  Span cogging;
  double drag_factor = 1.0;
  for (const Effect& effect : actuator.effects) {
    if (effect.kind->acts == Acts::kDrag) add(drag, over_angles(effect, at));
    if (effect.kind->acts == Acts::kMotorSideTorque) add(cogging, over_angles(effect, at));
    if (effect.kind->acts == Acts::kDragFactor) drag_factor *= effect.kind->law(effect, at);
  }
  drag_factor = std::max(0.0, drag_factor);
  return {drag_factor * drag.least + cogging.least, drag_factor * drag.greatest + cogging.greatest};
}

double after_mesh_Nm(const Actuator& actuator, double before_mesh_Nm, double direction) {
  if (before_mesh_Nm == 0.0) return 0.0;
  return before_mesh_Nm * mesh_factor(actuator, before_mesh_Nm * direction > 0.0);
}

double before_mesh_Nm(const Actuator& actuator, double after_mesh_Nm, double direction) {
  if (after_mesh_Nm == 0.0) return 0.0;
  return after_mesh_Nm / mesh_factor(actuator, after_mesh_Nm * direction > 0.0);
}

Span output_ripple_Nm(const Actuator& actuator, double torque_Nm) {
  Span sum;
  for (const Effect& effect : actuator.effects) {
    if (effect.kind->acts != Acts::kOutputTorque) continue;
    add(sum, scaled(harmonic_range(effect.harmonics), effect.proportional ? torque_Nm : 1.0));
  }
  return sum;
}

}  // namespace torquewright::actuator
