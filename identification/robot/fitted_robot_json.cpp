// SPDX-License-Identifier: Apache-2.0
#include "identification/robot/fitted_robot_json.hpp"

#include <memory>
#include <nlohmann/json.hpp>

#include "actuator/effects/every_effect.hpp"
#include "identification/rig/joint_actuator_json.hpp"

namespace torquewright::identification {
namespace {

using nlohmann::ordered_json;

double parameter_of(const actuator::Actuator& drive, const actuator::EffectKind& effect) {
  for (const actuator::Effect& each : drive.effects) {
    if (each.kind == &effect) return each.values.front();
  }
  return 0.0;
}

ordered_json* entry_named(ordered_json& list, const std::string& name) {
  for (ordered_json& each : list) {
    if (each.value("name", "") == name) return &each;
  }
  return nullptr;
}

bool is_moved_by_mechanism(const ordered_json& document, const std::string& joint) {
  const ordered_json mechanisms = document.value("mechanisms", ordered_json::array());
  for (const ordered_json& each : mechanisms) {
    if (each.dump().find('"' + joint + '"') != std::string::npos) return true;
  }
  return false;
}

void set_body(ordered_json& document, const LoadReading& reading) {
  ordered_json* body = entry_named(document["bodies"], reading.body);
  if (body == nullptr) return;
  if (reading.which.of == FreeValue::Of::kMass) {
    (*body)["mass_kg"] = body->value("mass_kg", 0.0) + reading.change;
    return;
  }
  ordered_json center = body->value("center_of_mass_m", ordered_json::array({0.0, 0.0, 0.0}));
  center[reading.which.parameter] = center[reading.which.parameter].get<double>() + reading.change;
  (*body)["center_of_mass_m"] = center;
}

}  // namespace

ordered_json fitted_robot(const io::Document& nominal, const Rig& rig, const RobotModel& fitted,
                          const LoadErrors& load) {
  ordered_json document = ordered_json::parse(nominal.root.dump());
  for (std::size_t i = 0; i < rig.joints.size(); ++i) {
    ordered_json* joint = entry_named(document["joints"], rig.joints[i]);
    if (joint == nullptr || is_moved_by_mechanism(document, rig.joints[i])) continue;
    const actuator::Actuator& drive = fitted.drives[i];
    const double ratio = drive.transmission.ratio;
    (*joint)["reflected_inertia_kg_m2"] = drive.motor.rotor_inertia_kg_m2 * ratio * ratio;
    (*joint)["damping_Nm_s_rad"] = parameter_of(drive, actuator::effects::viscous_friction);
    (*joint)["dry_friction_Nm"] = parameter_of(drive, actuator::effects::coulomb_friction);
    joint->erase("static_friction_Nm");
  }
  for (const LoadReading& each : certain_errors(load)) set_body(document, each);
  return document;
}

RobotModel model_of_robot(const hopper::Robot& robot, const Rig& rig,
                          const std::vector<JointController>& controllers) {
  Rig read = rig;
  RobotLoad load = *rig.load.robot;
  for (std::size_t body = 0; body < load.tree.bodies.size(); ++body) {
    load.tree.bodies[body].inertia = robot.tree.bodies[body].inertia;
  }
  for (std::size_t i = 0; i < load.bodies.size(); ++i) {
    load.joints[i] = robot.tree.bodies[load.bodies[i]].joint;
  }
  read.load.robot = std::make_shared<const RobotLoad>(std::move(load));
  std::vector<actuator::ReadActuator> actuators;
  std::vector<const actuator::Actuator*> drives;
  for (std::size_t i = 0; i < rig.joints.size(); ++i)
    actuators.push_back(actuator_of_joint(read, i));
  for (const actuator::ReadActuator& each : actuators) drives.push_back(&each.actuator);
  RobotModel model = robot_model(read, drives);
  model.controllers = controllers;
  return model;
}

}  // namespace torquewright::identification
