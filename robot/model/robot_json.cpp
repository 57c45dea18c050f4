// SPDX-License-Identifier: Apache-2.0
#include "robot/model/robot_json.hpp"

#include <nlohmann/json.hpp>

#include "robot/mechanisms/library_spec.hpp"
#include "robot/model/follower_spec.hpp"
#include "robot/parts/body_keys.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::BaseKind;
using dynamics::JointKind;
using nlohmann::ordered_json;

ordered_json list_of(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

ordered_json base_json(const dynamics::Tree& tree) {
  ordered_json keys;
  keys["body"] = tree.bodies.front().name;
  keys["motion"] = tree.base == BaseKind::kFixed    ? "fixed"
                   : tree.base == BaseKind::kPlanar ? "planar"
                                                    : "spatial";
  if (tree.base == BaseKind::kFixed) {
    add_pose(keys, tree.bodies.front().joint.p_PB_m, tree.bodies.front().joint.R_PB);
  }
  return keys;
}

ordered_json body_json(const dynamics::Body& body) {
  ordered_json keys;
  keys["name"] = body.name;
  add_inertia(keys, body.inertia);
  return keys;
}

ordered_json joint_json(const Robot& robot, std::size_t index) {
  const dynamics::Body& body = robot.tree.bodies[index];
  const std::string& parent = robot.tree.bodies[body.parent].name;
  const dynamics::Joint& joint = body.joint;
  const bool turns = joint.kind == JointKind::kRevolute;
  ordered_json keys;
  keys["name"] = joint.name;
  keys["type"] = turns ? "revolute" : "prismatic";
  keys["parent"] = parent;
  keys["child"] = body.name;
  add_joint(keys, joint);
  // A joint that states an inertia takes none from its actuators: zero is not said of one unasked.
  if (robot.states_rotor(index, joint)) {
    keys[turns ? "reflected_inertia_kg_m2" : "reflected_mass_kg"] = joint.reflected_inertia;
  }
  if (!joint.rotor_spin_kg_m2.isZero(0)) {
    keys["rotor_spin_kg_m2"] = list_of(joint.rotor_spin_kg_m2);
  }
  return keys;
}

ordered_json drivetrain_json(const Robot& robot, const Drivetrain& drivetrain) {
  ordered_json keys;
  keys["type"] = drivetrain.mechanism->type();
  for (const std::size_t body : drivetrain.joints) {
    keys["joints"].push_back(robot.tree.bodies[body].joint.name);
  }
  keys["actuators"] = drivetrain.actuator_files;
  if (drivetrain.joints.size() > 1) keys["actuator_names"] = drivetrain.actuator_names;
  keys.update(mechanism_keys(*drivetrain.mechanism));
  if (!drivetrain.stated_rotors_kg_m2.empty()) {
    keys["reflected_inertia_kg_m2"] = drivetrain.stated_rotors_kg_m2;
  }
  if (!drivetrain.cranks_kg_m2.empty()) keys["crank_inertia_kg_m2"] = drivetrain.cranks_kg_m2;
  if (drivetrain.mount) {
    keys["mounted_on"] = {{"body", robot.tree.bodies[drivetrain.mount->body].name},
                          {"position_m", list_of(drivetrain.mount->p_B_m)}};
  }
  if (drivetrain.transmission_limit) {
    const TransmissionLimit& limit = *drivetrain.transmission_limit;
    keys["transmission_limit"] = {{"torque_Nm", limit.torque_Nm},
                                  {"side", limit.side == GearSide::kMotor ? "motor" : "joint"}};
  }
  return keys;
}

}  // namespace

ordered_json robot_json(const Robot& robot) {
  const std::vector<dynamics::Body>& bodies = robot.tree.bodies;
  ordered_json document;
  document["kind"] = "robot";
  document["version"] = 1;
  document["name"] = robot.name;
  document["gravity_m_s2"] = robot.tree.gravity_m_s2;
  document["base"] = base_json(robot.tree);
  document["bodies"] = ordered_json::array();
  document["joints"] = ordered_json::array();
  for (const dynamics::Body& body : bodies) document["bodies"].push_back(body_json(body));
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    document["joints"].push_back(joint_json(robot, i));
  }
  for (const ContactPoint& contact : robot.contacts) {
    document["contacts"].push_back({{"name", contact.name},
                                    {"body", bodies[contact.point.body].name},
                                    {"position_m", list_of(contact.point.p_B_m)},
                                    {"friction_coefficient", contact.friction_coefficient},
                                    {"restitution", contact.restitution}});
    if (contact.radius_m > 0) document["contacts"].back()["radius_m"] = contact.radius_m;
  }
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    document["mechanisms"].push_back(drivetrain_json(robot, drivetrain));
  }
  for (const Follower& follower : robot.followers) {
    document["followers"].push_back(follower_json(robot, follower));
  }
  if (!robot.battery.empty()) document["battery"] = nlohmann::json::parse(robot.battery);
  for (const CollisionSphere& sphere : robot.spheres) {
    document["collision_spheres"].push_back({{"body", bodies[sphere.center.body].name},
                                             {"center_m", list_of(sphere.center.p_B_m)},
                                             {"radius_m", sphere.radius_m}});
  }
  for (const Posture& posture : robot.postures) {
    document["postures"][posture.name] = ordered_json::object();
    for (std::size_t i = 1; i < bodies.size(); ++i) {
      document["postures"][posture.name][bodies[i].joint.name] =
          posture.joints[static_cast<Eigen::Index>(i) - 1];
    }
  }
  if (!robot.assumed.empty()) document["assumed"] = robot.assumed;
  return document;
}

}  // namespace torquewright::hopper
