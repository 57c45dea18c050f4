// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robot/mjcf/mjcf_joint.hpp"

namespace torquewright::hopper {

/// How our base frame stands in the top body of a file, and how our coordinates follow from its.
struct MjcfBase {
  dynamics::BaseKind kind = dynamics::BaseKind::kFixed;
  Eigen::Matrix3d R_DB = Eigen::Matrix3d::Identity();  ///< The file's body in our base's frame.
  Eigen::Vector3d p_DB_m = Eigen::Vector3d::Zero();
  std::vector<std::string> notes;
};

/// The base that the joints of a top body at this pose make: one free joint, or three slides and
/// three hinges (a ball joint's, too) that no actuator drives, which move a body as freely; slides
/// along the world's x and z and then a hinge about its y: a planar one; none with an armature.
/// Else the base is fixed. `driven`: joints with an actuator. Faults where a free joint is not
/// alone, or has an armature that may not be dropped: no base of ours holds one.
MjcfBase base_of(const Placed& pose, const std::vector<MjcfJoint>& joints,
                 const std::map<std::string, std::string>& driven, bool drops_armature,
                 Faults& faults);

}  // namespace torquewright::hopper
