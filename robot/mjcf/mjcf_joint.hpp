// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/tree.hpp"
#include "robot/mjcf/mjcf_context.hpp"

namespace torquewright::hopper {

/// A joint as MJCF has it, in its body's frame.
struct MjcfJoint {
  dynamics::Joint joint;  ///< Its frame in its parent is not set.
  Eigen::Vector3d place_m = Eigen::Vector3d::Zero();
  double reference = 0;  ///< Its position where the body stands as the file puts it.
  bool states_armature = false;
  bool is_free = false;
  bool is_ball = false;
  const Element* element = nullptr;
};

/// Hinges, slides, free joints and balls.
MjcfJoint read_mjcf_joint(const Placed& placed, const MjcfContext& context);

/// A fault: a ball joint is one of a linkage's rods, or three hinges, or not read.
void refuse_ball(const Element& joint, Faults& faults);
/// About x, y and z, in place of a ball joint, whose own forces act about other axes and are left
/// behind.
std::vector<MjcfJoint> hinges_of_ball(const MjcfJoint& ball);

/// Whether a range holds: as stated, or where none is stated and limits are automatic. Where they
/// are not it is a fault to state none.
bool is_limited(const Element& element, const char* limited, const MjcfContext& context);

/// What a range of force or control leaves in either direction, above zero: the smaller side.
/// Infinite where none holds. A range whose ends are in the wrong order, or that leaves nothing in
/// one direction, is a fault.
double force_either_way(const Element& element, const char* range, const char* limited,
                        const MjcfContext& context);

}  // namespace torquewright::hopper
