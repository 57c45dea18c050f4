// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/record/record.hpp"

namespace torquewright::hopper {

/// Returns the base's attitude at a position of the tree; of a planar base by its pitch, of a fixed
/// one none.
Eigen::Matrix3d base_attitude(const dynamics::Tree& tree, const Eigen::VectorXd& position);

/// How one attitude of a base differs from another.
struct AttitudeError {
  double lean_rad = 0.0;     ///< Angle between their verticals: how far it leans, whichever way.
  double heading_rad = 0.0;  ///< Turn about the world's vertical that brings them nearest, signed.
};

/// Returns by how much the base at a position is off that at a wanted one.
AttitudeError attitude_error(const dynamics::Tree& tree, const Eigen::VectorXd& wanted,
                             const Eigen::VectorXd& position);

/// Returns how far the base has turned from the motion's begin until a time, as a sum of small
/// turns in the world's axes, in rad: whole turns count. `period_s` is the time between the
/// positions that are compared.
Eigen::Vector3d planned_turn_rad(const dynamics::Tree& tree, const Reference& reference,
                                 double period_s, double until_s);

/// Returns the same of a run, from its first row on.
Eigen::Vector3d turned_rad(const dynamics::Tree& tree, const Record& record, double until_s);

/// Returns the axis about which a planned turn is judged: its own, or pitch where it hardly turns.
Eigen::Vector3d axis_of_turn(const Eigen::Vector3d& planned_rad);

}  // namespace torquewright::hopper
