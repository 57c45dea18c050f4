// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>

#include "robot/model/whole_body.hpp"

namespace torquewright::test {

constexpr Eigen::Index kCassieBase = 6;     ///< Velocities of the base.
constexpr Eigen::Index kCassieMotors = 10;  ///< Hip roll, yaw, pitch, knee, toe: left, then right.
/// How far the leaf springs are bent: shin, heel: left, then right.
using CassieSprings = Eigen::Vector4d;

/// Postures of Cassie by what its motors do: its authors publish these alone, of a robot whose
/// springs are rigid. Bent springs leave each foot as level as rigid ones do: the toe makes up.
class CassiePosture {
 public:
  /// The robot must outlive it.
  explicit CassiePosture(const hopper::Robot& robot);

  /// Positions of the tree's joints.
  Eigen::VectorXd joints(const Eigen::VectorXd& motors_rad, const CassieSprings& bent_rad) const;
  /// Rows of the motors in velocities.
  const std::array<Eigen::Index, kCassieMotors>& motor_rows() const { return motor_rows_; }
  /// Rows of the springs' rates (4 x n) in the posture of the body.
  Eigen::MatrixXd spring_rows(const hopper::WholeBody& body) const;

  /// How much each spring is bent by the robot's weight as it stands with both feet, with the least
  /// of forces, and the base where it stands (in `position`, whose joints are set).
  CassieSprings bent_by_weight(const Eigen::VectorXd& motors_rad, Eigen::VectorXd& position);

  /// Turns and moves the base so that the contact points come as near as can be to these places (3
  /// each), or, where only their heights count, to heights of 0 by the least motion.
  void stand(const Eigen::VectorXd& places_m, bool by_heights, Eigen::VectorXd& position);
  /// Places of the contact points (3 each).
  Eigen::VectorXd places_m(const Eigen::VectorXd& position);
  hopper::WholeBody& body() { return body_; }
  void set(const Eigen::VectorXd& position, const Eigen::VectorXd& velocity);

 private:
  struct Leg {
    std::size_t knee = 0, shin = 0, tarsus = 0, foot = 0;  ///< By body.
    const hopper::Follower* follower = nullptr;
    Eigen::Index heel = 0;  ///< The spring's place in the follower's positions.
    std::size_t heel_link = 0;
  };
  double heel_rad(const Leg& leg, double knee_rad, double shin_rad, double tarsus_rad) const;
  double tarsus_rad(const Leg& leg, double knee_rad, double shin_rad, double heel_rad) const;

  const hopper::Robot& robot_;
  hopper::WholeBody body_;
  std::array<Eigen::Index, kCassieMotors> motor_rows_{};
  std::array<Leg, 2> legs_;
};

}  // namespace torquewright::test
