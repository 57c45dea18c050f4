// SPDX-License-Identifier: Apache-2.0
#include "tests/real_data/motions/walk_control.hpp"

#include <Eigen/LU>

#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/mass_matrix.hpp"
#include "hopper/tracking/impact_invariant.hpp"

namespace torquewright::test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd foot_rows(dynamics::TreeState& state, const dynamics::BodyPoint& point) {
  Eigen::Matrix<double, 3, Eigen::Dynamic> all(3, kWalkVelocities);
  dynamics::point_jacobian(state, point, all);
  MatrixXd rows(2, kWalkVelocities);
  rows << all.row(0), all.row(2);
  return rows;
}

Eigen::Vector2d foot_bias_m_s2(dynamics::TreeState& state, const dynamics::BodyPoint& point) {
  const Eigen::Vector3d bias = dynamics::point_bias_acceleration_m_s2(state, point);
  return {bias.x(), bias.z()};
}

WalkControl::WalkControl(const hopper::Robot& robot, const Walk& walk, std::size_t before,
                         const Settings& settings)
    : before_(walk.at(before)),
      after_(walk.at(before + 1)),
      settings_(settings),
      feet_{robot.contacts.at(0).point, robot.contacts.at(1).point},
      state_(robot.tree) {}

VectorXd WalkControl::torque_Nm(double time_s, const VectorXd& position, const VectorXd& velocity) {
  state_.set(position, velocity);
  MatrixXd mass(kWalkVelocities, kWalkVelocities);
  dynamics::mass_matrix(state_, mass);
  VectorXd bias(kWalkVelocities);
  dynamics::bias(state_, bias);

  const MatrixXd joints = MatrixXd::Identity(kWalkVelocities, kWalkVelocities).bottomRows(4);
  const WalkInstant aim = wanted(time_s);
  VectorXd rate_error = joints * (aim.velocity - velocity);
  const MatrixXd landing = foot_rows(state_, feet_[after_.stance]);
  hopper::handle_impact(settings_.impact, time_s - impact_s(),
                        hopper::impact_map(mass, landing, joints), rate_error);
  const double damping = settings_.damping_1_s, stiffness = 0.25 * damping * damping;
  const VectorXd acceleration = joints * aim.acceleration +
                                stiffness * joints * (aim.position - position) +
                                damping * rate_error;

  // M a - S^T u - J^T f = -h,  J a = -J' v,  S a as asked for: in a, u, f.
  const MatrixXd stance = foot_rows(state_, feet_[mode_at(time_s).stance]);
  MatrixXd system = MatrixXd::Zero(13, 13);
  system.topLeftCorner(7, 7) = mass;
  system.block(0, 7, 7, 4) = -joints.transpose();
  system.block(0, 11, 7, 2) = -stance.transpose();
  system.block(7, 0, 2, 7) = stance;
  system.block(9, 0, 4, 7) = joints;
  VectorXd right_side(13);
  right_side << -bias, -foot_bias_m_s2(state_, feet_[mode_at(time_s).stance]), acceleration;
  return system.partialPivLu().solve(right_side).segment(7, kWalkJoints);
}

}  // namespace torquewright::test
