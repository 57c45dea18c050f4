// SPDX-License-Identifier: Apache-2.0
#include "actuator/motor/gear_transmission.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "gearbox/strength/problem_strength.hpp"
#include "gearbox/strength/torque_limit.hpp"
#include "gearbox/topologies/shifted_train.hpp"
#include "gearbox/topologies/topology.hpp"

namespace torquewright::actuator {
namespace {

GearTransmission objected(std::string sentence, std::string place = "") {
  GearTransmission train;
  train.objection = std::move(sentence);
  train.place = std::move(place);
  return train;
}

}  // namespace

GearTransmission gear_transmission(const gearbox::Problem& problem, const gearbox::Design& design) {
  gearbox::Problem gears = problem;
  gears.rotor_inertia_kg_m2 = 0;  // the motor's own is that of its actuator
  if (std::string why = gearbox::shift_objection(gears, design); !why.empty()) {
    return objected(std::move(why));
  }
  const gearbox::DesignReport report =
      gearbox::find_topology(gears.topology)->evaluate(gears, design);
  for (const gearbox::MeshReport& mesh : report.meshes) {
    if (mesh.efficiency > 0.0) continue;
    return objected(fmt::format("the mesh {} does not exist for these teeth", mesh.name));
  }
  for (const gearbox::ConstraintReport& constraint : report.constraints) {
    if (!design.is_shifted() || constraint.satisfied) continue;
    if (constraint.name.starts_with("coaxial.")) {
      return objected(constraint.sentence, "/profile_shift");
    }
  }
  GearTransmission train;
  train.transmission.ratio = report.ratio.get_d();
  train.transmission.forward_efficiency = report.forward_efficiency;
  train.transmission.backward_efficiency = report.backward_efficiency;
  train.transmission.inertia_kg_m2 = report.reflected_inertia_kg_m2.value_or(0.0);
  // The teeth's own limit is the gears' bound of the region; without steel or widths there is none.
  if (const auto strength = gearbox::strength_of_design(gears, design)) {
    train.transmission.peak_torque_Nm = gearbox::torque_limits(*strength).for_cycles.joint_Nm;
  }
  return train;
}

bool is_rated_at_joint(const Actuator& actuator) {
  for (const Statement& one : actuator.statements) {
    if (one.pointer == "/datasheet/rated_torque_Nm" && one.at_joint) return *one.at_joint;
  }
  return actuator.datasheet && actuator.datasheet->joint_side;
}

void carry_joint_rating(const Transmission& before, Actuator& actuator) {
  if (!actuator.datasheet || !actuator.datasheet->rated_torque_Nm) return;
  if (!is_rated_at_joint(actuator)) return;
  const auto gain = [](const Transmission& gears) {
    return std::abs(gears.ratio) * gears.forward_efficiency;
  };
  *actuator.datasheet->rated_torque_Nm *= gain(actuator.transmission) / gain(before);
}

}  // namespace torquewright::actuator
