// SPDX-License-Identifier: Apache-2.0
#include "actuator/exporters/exporter.hpp"

namespace torquewright::actuator {

std::string_view name_of(LawFit fit) { return fit == LawFit::kBest ? "best" : "conservative"; }

double Subject::ratio() const {
  return region.side() == Side::kMotor ? 1.0 : actuator.transmission.ratio;
}

double Subject::armature_kg_m2() const {
  const double rotor_kg_m2 = actuator.motor.rotor_inertia_kg_m2;
  if (region.side() == Side::kMotor) return rotor_kg_m2;
  return ratio() * ratio() * rotor_kg_m2 + actuator.transmission.inertia_kg_m2;
}

Actuator as_laws_brake(const Actuator& actuator) {
  Actuator braking = actuator;
  if (actuator.envelope) braking.envelope = with_full_braking(*actuator.envelope);
  return braking;
}

double Subject::bus_voltage_V() const { return open_circuit_voltage_V(actuator, conditions); }

}  // namespace torquewright::actuator
