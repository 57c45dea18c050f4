// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/friction/joint_friction.hpp"
#include "robot/urdf/urdf_writer.hpp"

namespace torquewright::hopper {

/// What an MJCF file may hold beside bodies and joints.
struct MjcfParts {
  bool actuators = false;     ///< Each drive's region, as `actuator mor --format mujoco` writes it.
  bool servos = false;        ///< With `actuators`: drives are told angles, not voltages.
  bool ground = false;        ///< A plane, and keyframes of the postures that stand on it.
  bool closed_loops = false;  ///< Cranks and rods of linkages as bodies, in place of frozen rotors.
  bool collisions = false;    ///< Small balls at the contact points, and the collision spheres.
  /// Where the friction of drives stands, with `actuators`; that of a gear that locks itself is in
  /// the limits all the same.
  actuator::FrictionPlace friction = actuator::FrictionPlace::kJoint;
};

/// Writes the robot for MuJoCo 2.2.2 and later: bodies with their inertia, joints with reflected
/// inertia as armature, motors with the torque limits, contact points as sites.
Exported mjcf_of(const Robot& robot, const MjcfParts& parts = {});

}  // namespace torquewright::hopper
