// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "dynamics/tree.hpp"

namespace torquewright::hopper {

/// A list of three under that key; zero where it is absent.
Eigen::Vector3d vector_of(const nlohmann::json& keys, const char* key);
/// By rotation_rpy_rad.
Eigen::Matrix3d rotation_of(const nlohmann::json& keys);
/// Mass, centre of mass and inertia about it; those that are absent are zero.
dynamics::RigidInertia inertia_of(const nlohmann::json& keys);
/// All that a joint's keys say but its name. Requires that joint_objections() has none.
dynamics::Joint joint_of(const nlohmann::json& keys);

/// A key of a joint, and what is wrong with it.
struct JointObjection {
  std::string key;
  std::string message;
};
/// Of an axis without direction, keys of the other kind of joint, frictions and ranges that
/// contradict themselves.
std::vector<JointObjection> joint_objections(const nlohmann::json& keys);

void add_pose(nlohmann::ordered_json& keys, const Eigen::Vector3d& p_m, const Eigen::Matrix3d& R);
/// Adds nothing where there is no mass.
void add_inertia(nlohmann::ordered_json& keys, const dynamics::RigidInertia& inertia);
/// What joint_of() reads but what rotors weigh at the joint.
void add_joint(nlohmann::ordered_json& keys, const dynamics::Joint& joint);

}  // namespace torquewright::hopper
