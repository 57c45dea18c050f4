// SPDX-License-Identifier: Apache-2.0
#include "actuator/exporters/exporter.hpp"

namespace torquewright::actuator {
namespace {

/// A table holds what the document says; a law of few numbers what it can.
Actuator as_written(const Actuator& stated, const Exporter& exporter) {
  return exporter.parameters.empty() ? stated : as_laws_brake(stated);
}

/// What the limits are of.
Actuator limited(const Actuator& whole, const Exporter& exporter, FrictionPlace place) {
  if (place == FrictionPlace::kLimits) return whole;
  return exporter.friction.dry == DryFriction::kComposed ? without_losses(whole)
                                                         : without_friction(whole);
}

}  // namespace

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

FrictionPlace usual_place(const Exporter& exporter, const Actuator& actuator, Side side) {
  const bool can_hold = exporter.friction.dry != DryFriction::kNone && side == Side::kJoint &&
                        !locks_itself(actuator);
  return can_hold ? FrictionPlace::kJoint : FrictionPlace::kLimits;
}

double Subject::bus_voltage_V() const { return open_circuit_voltage_V(actuator, conditions); }

ExportedDrive::ExportedDrive(const Actuator& stated, const Exporter& exporter,
                             const ExportChoices& choices)
    : whole_(as_written(stated, exporter)),
      written_(limited(whole_, exporter, choices.friction)),
      region_(written_, choices.conditions, choices.side),
      table_(mor_table(region_, choices.table_accuracy)),
      subject_{written_, choices.conditions, region_, table_, choices.fit} {
  if (choices.friction == FrictionPlace::kLimits) return;
  subject_.whole = &whole_;
  subject_.friction = joint_friction(whole_, winding_temperature_K(whole_, choices.conditions),
                                     region_.greatest_speed_rad_s());
}

}  // namespace torquewright::actuator
