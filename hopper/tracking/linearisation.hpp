// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hopper/tracking/contact_rows.hpp"
#include "robot/model/linear_dynamics.hpp"
#include "robot/model/whole_body.hpp"

namespace torquewright::hopper {

// Errors of a state (2 n x 1): position_difference() from the reference, then velocities' (n x 1).

/// State at which slopes are computed: (position_size x 1), (n x 1), (drives x 1).
struct DrivenState {
  Eigen::VectorXd position;
  Eigen::VectorXd velocity;
  Eigen::VectorXd drive_Nm;
};

/// A value (n x 1) and its derivatives by the state.
struct StateSlopes {
  Eigen::VectorXd value;
  Eigen::MatrixXd by_position;  ///< (n x n), along the directions of the velocities.
  Eigen::MatrixXd by_velocity;  ///< (n x n)
  Eigen::MatrixXd by_drive;     ///< (n x drives); empty where no drive acts.
};

/// Returns the speeds of the drives' outputs per velocity: A (drives x n) at the posture that was
/// set. Torques there act on the velocities as A^T.
Eigen::MatrixXd drive_jacobian(const WholeBody& body);

/// Returns the accelerations (n x 1) under the drives' torques while the touching points hold to
/// the ground, which pulls too, if it must (docs/derivations/tracking.md eq. (3)). Points of one
/// foot may hold each other's rows twice. None where a mechanism does not reach the posture.
std::optional<Eigen::VectorXd> held_acceleration(WholeBody& body, const DrivenState& at,
                                                 const TouchingPoints& touches);

/// Returns by how much generalised forces (n x k) change those accelerations (n x k).
std::optional<Eigen::MatrixXd> held_answers(WholeBody& body, const DrivenState& at,
                                            const TouchingPoints& touches,
                                            const Eigen::MatrixXd& forces);

/// Returns the least forces of the ground that then hold them, by contact point of the robot (3
/// each, world's axes, on the robot); linear in the torques.
std::optional<Eigen::Matrix3Xd> ground_forces_N(WholeBody& body, const DrivenState& at,
                                                const TouchingPoints& touches);

/// Returns the accelerations with their slopes, eq. (4), exact where the touching points are at
/// rest. `dynamics` is of the same robot.
std::optional<StateSlopes> acceleration_slopes(WholeBody& body, LinearDynamics& dynamics,
                                               const DrivenState& at,
                                               const TouchingPoints& touches);

/// Returns the velocities after an impact that stops the touching points, eq. (5), with their
/// slopes.
std::optional<StateSlopes> impact_slopes(WholeBody& body, const DrivenState& at,
                                         const TouchingPoints& touches);

/// Error dynamics along the motion through a state: d(error)/dt = A error + B torque, eq. (6).
struct ContinuousModel {
  Eigen::MatrixXd by_error;  ///< (2 n x 2 n), 1/s
  Eigen::MatrixXd by_drive;  ///< (2 n x drives), 1/s per Nm
};
ContinuousModel continuous_model(const dynamics::Tree& tree, const StateSlopes& acceleration,
                                 const Eigen::VectorXd& velocity);

/// Error dynamics over a period while torques are held: the exponential by its series up to the
/// fourth order, eq. (7).
struct DiscreteModel {
  Eigen::MatrixXd by_error;  ///< (2 n x 2 n)
  Eigen::MatrixXd by_drive;  ///< (2 n x drives), per Nm
};
DiscreteModel over(const ContinuousModel& model, double period_s);

}  // namespace torquewright::hopper
