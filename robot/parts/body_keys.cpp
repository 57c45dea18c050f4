// SPDX-License-Identifier: Apache-2.0
#include "robot/parts/body_keys.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "robot/parts/passive_keys.hpp"
#include "robot/parts/rotations.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::JointKind;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using nlohmann::json;
using nlohmann::ordered_json;

constexpr double kShortestAxis = 1e-6;
constexpr std::array kRevoluteKeys{"range_rad", "speed_limit_rad_s", "torque_limit_Nm",
                                   "reflected_inertia_kg_m2"};
constexpr std::array kPrismaticKeys{"range_m", "speed_limit_m_s", "force_limit_N",
                                    "reflected_mass_kg"};

bool turns(const json& joint) { return joint["type"] == "revolute"; }

dynamics::PassiveForces passive_of(const json& joint) {
  dynamics::PassiveForces passive;
  for (const PassiveKey& key : kPassiveKeys) {
    passive.*key.value = joint.value(turns(joint) ? key.of_revolute : key.of_prismatic, 0.0);
  }
  return passive;
}

Matrix3d tensor_of(const json& value) {
  if (value.is_number()) return value.get<double>() * Matrix3d::Identity();
  const auto at = [&](const char* key) { return value.value(key, 0.0); };
  Matrix3d inertia;
  inertia << at("xx"), at("xy"), at("xz"), at("xy"), at("yy"), at("yz"), at("xz"), at("yz"),
      at("zz");
  return inertia;
}

ordered_json three_of(const Vector3d& v) { return {v[0], v[1], v[2]}; }

void object_to_friction(const json& joint, std::vector<JointObjection>& objections) {
  const dynamics::PassiveForces passive = passive_of(joint);
  const char* key = turns(joint) ? "static_friction_Nm" : "static_friction_N";
  if (!joint.contains(key) || passive.static_friction >= passive.dry_friction) return;
  objections.push_back(
      {key, fmt::format("{:g} is less than the joint's dry friction of {:g}, which holds at rest "
                        "too; state as much or leave it out",
                        passive.static_friction, passive.dry_friction)});
}

}  // namespace

Vector3d vector_of(const json& keys, const char* key) {
  if (!keys.contains(key)) return Vector3d::Zero();
  const json& list = keys[key];
  return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

Matrix3d rotation_of(const json& keys) {
  return rotation_of_rpy(vector_of(keys, "rotation_rpy_rad"));
}

dynamics::RigidInertia inertia_of(const json& keys) {
  dynamics::RigidInertia inertia;
  inertia.mass_kg = keys.value("mass_kg", 0.0);
  inertia.center_of_mass_m = vector_of(keys, "center_of_mass_m");
  if (keys.contains("inertia_kg_m2")) inertia.inertia_kg_m2 = tensor_of(keys["inertia_kg_m2"]);
  return inertia;
}

dynamics::Joint joint_of(const json& keys) {
  const bool is_hinge = turns(keys);
  dynamics::Joint joint;
  joint.kind = is_hinge ? JointKind::kRevolute : JointKind::kPrismatic;
  joint.p_PB_m = vector_of(keys, "position_m");
  joint.R_PB = rotation_of(keys);
  const Vector3d axis = vector_of(keys, "axis");
  if (axis.norm() >= kShortestAxis) joint.axis = axis.normalized();
  joint.rotor_spin_kg_m2 = vector_of(keys, "rotor_spin_kg_m2");
  joint.reflected_inertia =
      keys.value(is_hinge ? "reflected_inertia_kg_m2" : "reflected_mass_kg", 0.0);
  joint.passive = passive_of(keys);
  dynamics::JointLimits& limits = joint.limits;
  const char* range = is_hinge ? "range_rad" : "range_m";
  // What is no range was reported.
  if (keys.contains(range) && keys[range][0] < keys[range][1]) {
    limits.position_min = keys[range][0];
    limits.position_max = keys[range][1];
  }
  limits.speed_max =
      keys.value(is_hinge ? "speed_limit_rad_s" : "speed_limit_m_s", limits.speed_max);
  limits.effort_max = keys.value(is_hinge ? "torque_limit_Nm" : "force_limit_N", limits.effort_max);
  for (const std::string own : keys.value("own_limits", json::array())) {
    (own == "speed" ? limits.owns_speed : limits.owns_effort) = true;
  }
  return joint;
}

std::vector<JointObjection> joint_objections(const json& keys) {
  std::vector<JointObjection> objections;
  if (vector_of(keys, "axis").norm() < kShortestAxis) {
    objections.push_back({"axis", "has no direction"});
  }
  const bool is_hinge = turns(keys);
  const auto refuse_other = [&](const char* key) {
    if (!keys.contains(key)) return;
    objections.push_back(
        {key, fmt::format("is for {} joints", is_hinge ? "prismatic" : "revolute")});
  };
  for (const char* key : is_hinge ? kPrismaticKeys : kRevoluteKeys) refuse_other(key);
  for (const PassiveKey& key : kPassiveKeys) {
    refuse_other(is_hinge ? key.of_prismatic : key.of_revolute);
  }
  object_to_friction(keys, objections);
  const char* range = is_hinge ? "range_rad" : "range_m";
  if (keys.contains(range) && !(keys[range][0] < keys[range][1])) {
    objections.push_back({range, fmt::format("{} is not below {}: least position first",
                                             keys[range][0].dump(), keys[range][1].dump())});
  }
  return objections;
}

void add_pose(ordered_json& keys, const Vector3d& p_m, const Matrix3d& R) {
  if (!p_m.isZero(0)) keys["position_m"] = three_of(p_m);
  if (!R.isIdentity(0)) keys["rotation_rpy_rad"] = three_of(rpy_of_rotation(R));
}

void add_inertia(ordered_json& keys, const dynamics::RigidInertia& inertia) {
  if (!(inertia.mass_kg > 0)) return;
  const Matrix3d& I = inertia.inertia_kg_m2;
  keys["mass_kg"] = inertia.mass_kg;
  keys["center_of_mass_m"] = three_of(inertia.center_of_mass_m);
  keys["inertia_kg_m2"] = {{"xx", I(0, 0)}, {"yy", I(1, 1)}, {"zz", I(2, 2)},
                           {"xy", I(0, 1)}, {"xz", I(0, 2)}, {"yz", I(1, 2)}};
}

void add_joint(ordered_json& keys, const dynamics::Joint& joint) {
  const bool is_hinge = joint.kind == JointKind::kRevolute;
  add_pose(keys, joint.p_PB_m, joint.R_PB);
  keys["axis"] = three_of(joint.axis);
  const dynamics::JointLimits& limits = joint.limits;
  if (std::isfinite(limits.position_min) && std::isfinite(limits.position_max)) {
    keys[is_hinge ? "range_rad" : "range_m"] = {limits.position_min, limits.position_max};
  }
  if (std::isfinite(limits.speed_max)) {
    keys[is_hinge ? "speed_limit_rad_s" : "speed_limit_m_s"] = limits.speed_max;
  }
  if (std::isfinite(limits.effort_max)) {
    keys[is_hinge ? "torque_limit_Nm" : "force_limit_N"] = limits.effort_max;
  }
  if (limits.owns_speed) keys["own_limits"].push_back("speed");
  if (limits.owns_effort) keys["own_limits"].push_back("torque");
  for (const PassiveKey& key : kPassiveKeys) {
    const double value = joint.passive.*key.value;
    if (value != 0) keys[is_hinge ? key.of_revolute : key.of_prismatic] = value;
  }
}

}  // namespace torquewright::hopper
