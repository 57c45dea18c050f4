// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "actuator/motor/actuator.hpp"

namespace torquewright::actuator {

/// Where a simulator's file has the friction of a drive that does not depend on its load.
enum class FrictionPlace {
  kLimits,  ///< Off the limits: a command below them arrives whole.
  kJoint,   ///< In the joint: a command is the torque that the motor brings there.
};
std::string_view name_of(FrictionPlace place);

/// The dry friction that a simulator's joint can have.
enum class DryFriction {
  kNone,       ///< None: a drive's friction is in the limits.
  kOneValue,   ///< The same in motion and at rest.
  kBreakaway,  ///< One in motion and one at rest.
  kSmoothed,   ///< In motion; at rest none, it fades towards it.
  kComposed,   ///< The drive's own law, with its losses in proportion to load.
};

/// Friction that a joint of a simulator has of its own, against the motion: a dry torque and one in
/// proportion to the speed.
struct JointFriction {
  double coulomb_Nm = 0.0;
  double breakaway_Nm = 0.0;  ///< Dry friction at rest; not below the former.
  double viscous_Nm_s_rad = 0.0;
  friend bool operator==(const JointFriction&, const JointFriction&) = default;
};

/// The drive's friction as that, at the winding temperature: exact where its laws are dry and
/// viscous and alike both ways; else the mean of both ways by least squares over the speeds up to
/// `end_rad_s`, presliding friction by the level at which it slips.
JointFriction joint_friction(const Actuator& actuator, double temperature_K, double end_rad_s);

/// The drive's friction itself, in Nm against the motion: drag at its mean over all angles, and
/// presliding friction that slips.
double sliding_friction_Nm(const Actuator& actuator, double speed_rad_s, double direction,
                           double temperature_K);

/// The part of sliding_friction_Nm that no region holds, since its law has a state.
double presliding_level_Nm(const Actuator& actuator, double direction, double temperature_K);

/// The drive without the friction that joint_friction stands for; its gear still loses.
Actuator without_friction(const Actuator& actuator);

/// The motor's torque carried to the joint: without that friction, the gear's losses, its limit
/// and the waves.
Actuator without_losses(const Actuator& actuator);

/// Whether the load cannot drive the motor back: no friction of a joint holds that.
bool locks_itself(const Actuator& actuator);

/// What the simulator's joint cannot hold of the friction, each with the torque by which it is off.
/// `has_breakaway`: it has a dry friction at rest apart. `greatest_Nm`: of the torque limits.
std::vector<std::string> friction_not_held(const Actuator& actuator, double temperature_K,
                                           double end_rad_s, bool has_breakaway,
                                           double greatest_Nm);

}  // namespace torquewright::actuator
