// SPDX-License-Identifier: Apache-2.0
#include "actuator/heat/temperature_laws.hpp"

#include <algorithm>

#include "actuator/effects/temperature_factor.hpp"

namespace torquewright::actuator {
namespace {

const Effect* stated_resistance_law(const Actuator& actuator) {
  const auto found = std::find_if(
      actuator.effects.begin(), actuator.effects.end(),
      [](const Effect& effect) { return effect.kind->acts == Acts::kResistanceFactor; });
  return found == actuator.effects.end() ? nullptr : &*found;
}

/// Of one phase, at the reference temperature.
double stated_phase_ohm(const Motor& motor) {
  return motor.resistance_ohm * phase_ohms_per_ohm(motor.resistance_convention);
}

}  // namespace

double resistance_coefficient_1_K(const Actuator& actuator) {
  const Effect* stated = stated_resistance_law(actuator);
  return stated != nullptr ? stated->values[0] : kCopperCoefficient_1_K;
}

double resistance_factor(const Actuator& actuator, const Instant& at) {
  const Effect* stated = stated_resistance_law(actuator);
  if (stated != nullptr) return stated->kind->law(*stated, at);
  return effects::temperature_factor(kCopperCoefficient_1_K, at);
}

double phase_resistance_ohm(const Actuator& actuator, double temperature_K) {
  return stated_phase_ohm(actuator.motor) *
         resistance_factor(actuator, at_winding_temperature(actuator, temperature_K));
}

double winding_loss_W(const Actuator& actuator, double phase_amplitude_A, const Instant& at) {
  return 1.5 * stated_phase_ohm(actuator.motor) * resistance_factor(actuator, at) *
         phase_amplitude_A * phase_amplitude_A;
}

}  // namespace torquewright::actuator
