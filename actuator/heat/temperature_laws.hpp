// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/effects/acting.hpp"
#include "actuator/motor/actuator.hpp"

namespace torquewright::actuator {

/// How the motor's constants follow the winding's temperature: linear laws about the temperature at
/// which the document states them. Every region, check, identification and simulation asks here.

/// Returns an instant at which only the winding's temperature differs from the document's own.
inline Instant at_winding_temperature(const Actuator& actuator, double temperature_K) {
  Instant at;
  at.winding_temperature_K = temperature_K;
  at.reference_temperature_K = actuator.motor.winding_temperature_K;
  return at;
}

/// Relative change of the winding's resistance per kelvin: that of a stated effect, else copper's.
double resistance_coefficient_1_K(const Actuator& actuator);

/// Resistance over that at the reference temperature. Not positive where the linear law ends.
double resistance_factor(const Actuator& actuator, const Instant& at);

/// Resistance of one phase at that winding temperature, in ohm.
double phase_resistance_ohm(const Actuator& actuator, double temperature_K);

/// Product of the factors of all effects on the magnets' flux, for torque constant and back-EMF
/// alike.
inline double flux_factor(const Actuator& actuator, const Instant& at) {
  return product_of_laws(actuator.effects, Acts::kFluxFactor, at);
}

/// Copper loss of the three phases, in W: 1.5 R i^2 of a phase current's amplitude.
double winding_loss_W(const Actuator& actuator, double phase_amplitude_A, const Instant& at);

}  // namespace torquewright::actuator
