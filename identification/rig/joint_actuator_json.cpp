// SPDX-License-Identifier: Apache-2.0
#include "identification/rig/joint_actuator_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "actuator/effects/every_effect.hpp"
#include "io/documents/document.hpp"
#include "io/faults/refusal.hpp"

namespace torquewright::identification {
namespace {

using nlohmann::json;

// Of a drive of which nothing is known: no limit that a leg or an arm comes to.
constexpr double kEffort_Nm = 1000.0;
constexpr double kSpeed_rad_s = 100.0;
/// A winding that takes no share of the bus voltage.
constexpr double kResistance_ohm = 1e-3;

double stated_or(double limit, double otherwise) {
  return std::isfinite(limit) && limit > 0.0 ? limit : otherwise;
}

json effects_of(const dynamics::PassiveForces& passive) {
  json effects = json::array();
  if (passive.damping > 0.0) {
    effects.push_back({{"effect", actuator::effects::viscous_friction.name},
                       {"parameters", {{"viscous_Nm_s_rad", passive.damping}}}});
  }
  if (passive.dry_friction > 0.0) {
    effects.push_back({{"effect", actuator::effects::coulomb_friction.name},
                       {"parameters", {{"coulomb_Nm", passive.dry_friction}}}});
  }
  if (passive.stiffness > 0.0) {
    effects.push_back({{"effect", actuator::effects::parallel_spring.name},
                       {"parameters",
                        {{"stiffness_Nm_rad", passive.stiffness},
                         {"neutral_angle_rad", passive.rest_position}}}});
  }
  return effects;
}

json document_of(const dynamics::Joint& joint, const std::string& robot_file) {
  return {{"kind", "actuator"},
          {"version", 1},
          {"name", fmt::format("{} as {} has it", joint.name, robot_file)},
          {"motor",
           {{"torque_constant_Nm_A", 1.0},
            {"torque_constant_convention", "dc"},
            {"resistance_ohm", kResistance_ohm},
            {"resistance_convention", "dc"},
            {"pole_pairs", 1},
            {"rotor_inertia_kg_m2", joint.reflected_inertia},
            {"winding_temperature_K", 298.15}}},
          {"drive",
           {{"bus_voltage_V", stated_or(joint.limits.speed_max, kSpeed_rad_s)},
            {"peak_current_A", stated_or(joint.limits.effort_max, kEffort_Nm)}}},
          {"gearbox", {{"ratio", 1}, {"forward_efficiency", 1}, {"backward_efficiency", 1}}},
          {"effects", effects_of(joint.passive)},
          {"assumed", {"/motor", "/drive", "/gearbox"}}};
}

}  // namespace

actuator::ReadActuator actuator_of_joint(const Rig& rig, std::size_t joint) {
  const RobotLoad& robot = *rig.load.robot;
  const std::string file = (std::filesystem::path(rig.file).parent_path() / robot.file).string();
  const dynamics::PassiveForces& passive = robot.joints[joint].passive;
  if (passive.static_friction > passive.dry_friction) {
    io::refuse(file,
               fmt::format("{} holds {:g} Nm at rest where it takes {:g} moving, and at which "
                           "speed it changes is not stated; name its drive, --actuator "
                           "{}=FILE, with stribeck friction",
                           rig.joints[joint], passive.static_friction, passive.dry_friction,
                           rig.joints[joint]));
  }
  return actuator::read_actuator(io::check_document(document_of(robot.joints[joint], robot.file),
                                                    "actuator", file,
                                                    "/joints/" + rig.joints[joint]));
}

}  // namespace torquewright::identification
