// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/motor/actuator.hpp"
#include "identification/rig/rig.hpp"

namespace torquewright::identification {

/// A robot as it is simulated under its own loops: what its drives move, and the drives, in the
/// order of the rig's joints.
struct RobotModel {
  Load load;
  std::vector<actuator::Actuator> drives;
  std::vector<JointController> controllers;  ///< Of the joints, in their order.
  /// By joint, what its encoder reads too little: the joint stands at reading + offset.
  std::vector<double> offset_rad;
};

/// The robot of a rig with these drives and encoders that read what is.
RobotModel robot_model(const Rig& rig, const std::vector<const actuator::Actuator*>& drives);

/// Joints that move nothing but each other and what they carry, since the base and the joints that
/// the log does not hold stand still: a leg of a robot whose base is held.
struct Limb {
  std::vector<std::size_t> joints;  ///< Indices into Rig::joints, ascending.
  Load load;                        ///< The robot's bodies without those of other limbs.
};

/// Takes a robot apart. What one limb does changes nothing in another, so that each may be
/// simulated by itself: exact, and a fourth of the work for a robot of four legs.
std::vector<Limb> limbs_of(const Load& robot);

}  // namespace torquewright::identification
