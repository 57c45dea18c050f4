// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "hopper/motion/motion.hpp"
#include "tests/real_data/cassie/cassie_posture.hpp"

namespace torquewright::test {

/// What Cassie's authors publish of their jump: its motors, at three times eight knots, of which
/// two are shared: it crouches, flies, lands.
struct PublishedJump {
  std::vector<double> times_s;
  Eigen::MatrixXd positions_rad, velocities_rad_s, torques_Nm;  ///< (10 x 22)
};
PublishedJump read_jump(const std::filesystem::path& file);

/// What had to be added for the jump to be a motion of all of the robot.
struct JumpClosure {
  CassieSprings bent_rad = CassieSprings::Zero();           ///< By its weight, all the time.
  Eigen::Vector3d take_off_m_s = Eigen::Vector3d::Zero();   ///< Of the centre of mass, by the legs,
  Eigen::Vector3d flight_m_s = Eigen::Vector3d::Zero();     ///< and that which lands level.
  Eigen::Vector3d take_off_Nm_s = Eigen::Vector3d::Zero();  ///< Angular momentum by the legs,
  Eigen::Vector3d flight_Nm_s = Eigen::Vector3d::Zero();    ///< and that which lands level.
  double foot_slip_m = 0.0;  ///< The most that a foot is off its place between knots.
};

/// The jump with its base: by the feet, which stand at both ends, and in the air by momentum, which
/// is that with which both feet come down level. Motors are cubic between knots; springs stay bent
/// as the weight bends them at first.
hopper::Motion jump_motion(const hopper::Robot& robot, const PublishedJump& jump,
                           JumpClosure& closure);

/// Stands in the jump's first posture.
hopper::Motion standing_motion(const hopper::Robot& robot, const PublishedJump& jump,
                               double duration_s);

}  // namespace torquewright::test
