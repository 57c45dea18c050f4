// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "robot/mjcf/mjcf_compiler.hpp"
#include "robot/mjcf/mjcf_defaults.hpp"
#include "robot/xml/vocabulary.hpp"

namespace torquewright::hopper {

/// What those who read parts of one MJCF file share.
struct MjcfContext {
  const MjcfCompiler& compiler;
  const MjcfDefaults& defaults;
  Vocabulary& vocabulary;
  Faults& faults;
};

/// An element inside a body, and where the frames around it put its own frame of reference.
struct Placed {
  const Element* element;
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d p_m = Eigen::Vector3d::Zero();
  std::string childclass;  ///< Around it.
};

/// Where the element itself stands by its own pos and orientation, in the body that holds it.
Placed pose_of(const Placed& placed, const Element& completed, const MjcfContext& context);

/// What a body (or the world) holds, frames taken apart, in order. Both are checked by the
/// vocabulary. In global coordinates the frame of reference is the world's.
std::vector<Placed> contents(const Element& body, const std::string& childclass,
                             const MjcfContext& context);

}  // namespace torquewright::hopper
