// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/jet.hpp"
#include "robot/model/whole_body.hpp"

namespace torquewright::hopper {

/// Where a robot is, how it moves and what acts on it.
struct DynamicsInstant {
  Eigen::VectorXd position;      ///< (position_size x 1)
  Eigen::VectorXd velocity;      ///< (n x 1)
  Eigen::VectorXd acceleration;  ///< (n x 1)
  Eigen::VectorXd drive_Nm;      ///< (drives x 1) at their outputs, rotors included.
  /// (3 x contact points), world's axes, on the robot; zero where a point does not touch.
  Eigen::Matrix3Xd contact_N;
};

/// The equations of motion about an instant. With A of the drivetrains and J of the touching
/// points, r = M a + h + rotors - A^T drives - J^T contacts and c = J a + J' v, the rate of the
/// touching points' velocities (of a ball: of what is under its centre). "By position": per
/// displacement as dynamics::step_position() counts it, a spatial base turning about its own axes.
/// docs/derivations/jets.md eqs. (5), (6). By acceleration they are WholeBody::mass_matrix() and J,
/// by drives -A^T, by contacts -J^T.
struct DynamicsSlopes {
  Eigen::VectorXd residual;              ///< r (n x 1): zero where the instant obeys the equations.
  Eigen::MatrixXd residual_by_position;  ///< (n x n)
  Eigen::MatrixXd residual_by_velocity;  ///< (n x n)
  /// 3 rows per contact point of the robot, touching or not.
  Eigen::VectorXd contact_m_s;              ///< J v (3 points x 1)
  Eigen::MatrixXd contact_m_s_by_position;  ///< (3 points x n); by velocity it is J.
  Eigen::VectorXd contact_m_s2;             ///< c (3 points x 1)
  Eigen::MatrixXd contact_m_s2_by_position;
  Eigen::MatrixXd contact_m_s2_by_velocity;
};

/// Finds them, exact but for rounding, by numbers that carry gradients. Keeps its room: one object
/// for many instants of one robot, which must outlive it, in one thread.
class LinearDynamics {
 public:
  explicit LinearDynamics(const Robot& robot) : body_(robot) {}

  /// False where a mechanism does not reach the posture. std::invalid_argument on wrong sizes or
  /// numbers that are not finite. Resizes `out`.
  [[nodiscard]] bool at(const DynamicsInstant& instant, DynamicsSlopes& out);

 private:
  /// Slopes along the variables from `first` on, of displacements and velocities, as many as one
  /// number holds.
  bool pass(const DynamicsInstant& instant, int first, DynamicsSlopes& out);
  void contact_rows(int first, DynamicsSlopes& out);
  dynamics::VectorX<dynamics::Jet> contact_force(const DynamicsInstant& instant);

  WholeBodyOf<dynamics::Jet> body_;
};

}  // namespace torquewright::hopper
