// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/point.hpp"
#include "hopper/tracking/impact_handling.hpp"
#include "robot/model/robot.hpp"
#include "tests/real_data/motions/rabbit_walk.hpp"

namespace torquewright::test {

/// Rows of a foot's point in the plane: along x and z (2 x 7).
Eigen::MatrixXd foot_rows(dynamics::TreeState& state, const dynamics::BodyPoint& point);
/// What the rows' acceleration is without any of velocities (2 x 1), in m/s2.
Eigen::Vector2d foot_bias_m_s2(dynamics::TreeState& state, const dynamics::BodyPoint& point);

/// Joint-space inverse dynamics as seed 003 has it for Rabbit: torques that give the joints the
/// accelerations of the walking and those that damping and stiffness ask for, for a robot whose
/// planned foot stands. The mode changes at its planned time.
class WalkControl {
 public:
  struct Settings {
    double damping_1_s = 20.0;  ///< Stiffness is its square over 4, in 1/s2: critical.
    hopper::ImpactOptions impact;
  };

  /// Follows mode `before` of the walking and then the next one.
  WalkControl(const hopper::Robot& robot, const Walk& walk, std::size_t before,
              const Settings& settings);

  /// (4 x 1), in Nm.
  Eigen::VectorXd torque_Nm(double time_s, const Eigen::VectorXd& position,
                            const Eigen::VectorXd& velocity);
  /// The walking at a time, in the mode of that time.
  WalkInstant wanted(double time_s) const { return mode_at(time_s).at(time_s); }
  double impact_s() const { return before_.until_s(); }

 private:
  const WalkMode& mode_at(double time_s) const { return time_s < impact_s() ? before_ : after_; }

  WalkMode before_, after_;
  Settings settings_;
  std::array<dynamics::BodyPoint, 2> feet_;
  dynamics::TreeState state_;
};

}  // namespace torquewright::test
