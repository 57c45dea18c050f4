// SPDX-License-Identifier: Apache-2.0
// Oracles of specs/trajectory/hopper_flip.csv: conservation laws. Without contact no force acts on
// the base and CAM stands still; on the ground the contacts must give what the base needs, from
// inside the foot and the friction cone; the columns are each other's derivatives; and touch-down
// is the rigid impact of test::impact(), which knows nothing of how the motion was made.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/mass_matrix.hpp"
#include "dynamics/momentum.hpp"
#include "dynamics/position_step.hpp"
#include "hopper/motion/motion_reader.hpp"
#include "robot/model/robot_spec.hpp"
#include "robot/model/whole_body.hpp"
#include "tests/dynamics/rigid_impact.hpp"

namespace torquewright {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kOnGround_m = 1e-8;  // Nine digits of positions below 1 m, over four bodies.
constexpr Index kPitchRate = 4;       // Row of the base's angular velocity about y.

class FlipMotion : public testing::Test {
 protected:
  static std::string specs(const char* file) {
    return std::string(TORQUEWRIGHT_SOURCE_DIR "/specs/") + file;
  }

  void set(Index sample) { state.set(motion.positions.col(sample), motion.velocities.col(sample)); }
  double height_m(std::size_t contact) {
    return dynamics::point_position_m(state, robot.contacts[contact].point).z();
  }
  /// Forces on the base that are not gravity's or inertia's: in flight none, else the ground's.
  VectorXd needed(Index sample) {
    set(sample);
    VectorXd force(state.tree().velocity_size());
    dynamics::inverse_dynamics(state, motion.accelerations.col(sample), force);
    return force.head<6>();
  }
  bool flies(Index sample) {
    set(sample);
    return height_m(0) > kOnGround_m && height_m(2) > kOnGround_m;
  }

  hopper::Robot robot = hopper::read_robot(specs("robot/hopper.json")).robot;
  hopper::Motion motion =
      hopper::read_motion(robot, {specs("trajectory/hopper_flip.csv"), {}, {}, {}});
  dynamics::TreeState state{robot.tree};
  Index touch_down = 0;  // The first sample after the impact.
  double weight_N = 0;

  void SetUp() override {
    set(0);
    weight_N = dynamics::centroid(state).mass_kg * robot.tree.gravity_m_s2;
    for (Index i = 1; i < motion.samples(); ++i) {
      if (motion.time_s(i) == motion.time_s(i - 1)) touch_down = i;
    }
    ASSERT_GT(touch_down, 0);
  }
};

TEST_F(FlipMotion, ColumnsAreEachOthersDerivatives) {
  // Joints' accelerations are linear from sample to sample, so both rules are exact for them. What
  // is left is the base's: h^5/720 of the fifth derivative of positions, h^3/12 of the fourth,
  // below 1e7, and h^2/12 of the jump of acceleration where the heel phase begins, below 50.
  constexpr double kPosition = 2e-5;
  constexpr double kVelocity = 0.01;
  for (Index i = 1; i < motion.samples(); ++i) {
    if (i == touch_down) continue;
    const double h = motion.time_s(i) - motion.time_s(i - 1);
    ASSERT_LE(h, 0.002 + 1e-9);
    VectorXd stepped(motion.positions.rows());
    const VectorXd mean = 0.5 * (motion.velocities.col(i - 1) + motion.velocities.col(i)) -
                          h / 12 * (motion.accelerations.col(i) - motion.accelerations.col(i - 1));
    dynamics::step_position(robot.tree, motion.positions.col(i - 1), mean, h, stepped);
    EXPECT_LT((stepped - motion.positions.col(i)).cwiseAbs().maxCoeff(), kPosition) << i;
    const VectorXd gained =
        0.5 * h * (motion.accelerations.col(i - 1) + motion.accelerations.col(i));
    const VectorXd jump = motion.velocities.col(i) - motion.velocities.col(i - 1) - gained;
    EXPECT_LT(jump.cwiseAbs().maxCoeff(), kVelocity) << motion.time_s(i);
  }
}

TEST_F(FlipMotion, NothingActsOnTheBaseInFlightAndMomentumStands) {
  int flown = 0;
  double momentum_Nm_s = 0;
  for (Index i = 0; i < touch_down - 1; ++i) {
    if (!flies(i)) continue;
    EXPECT_LT(needed(i).cwiseAbs().maxCoeff(), 1e-3 * weight_N) << motion.time_s(i);
    const double now_Nm_s = dynamics::centroid(state).angular_momentum_Nm_s.y();
    if (flown++ == 0) momentum_Nm_s = now_Nm_s;
    EXPECT_NEAR(now_Nm_s, momentum_Nm_s, 1e-3);
  }
  EXPECT_GT(flown, 200);
  EXPECT_GT(momentum_Nm_s, 5.0);  // Forward, and about the published 6 Nm s.
}

TEST_F(FlipMotion, TheGroundGivesWhatTheBaseNeeds) {
  const double slack_N = 1e-3 * weight_N;  // Take-off is where the force is zero to rounding.
  for (Index i = 0; i < motion.samples(); ++i) {
    if (i == touch_down - 1 || flies(i)) continue;
    const VectorXd force = needed(i);
    EXPECT_GE(force[2], -slack_N) << motion.time_s(i);
    EXPECT_LE(std::abs(force[0]), 0.6 * force[2] + slack_N) << motion.time_s(i);
    EXPECT_LT(std::max({std::abs(force[1]), std::abs(force[3]), std::abs(force[5])}),
              1e-3 * weight_N);
    const double heel_m = dynamics::point_position_m(state, robot.contacts[0].point).x();
    const bool on_heel = height_m(2) > kOnGround_m;
    // Moment about +y and the heel, from that about the base's origin.
    const Vector3d base_m = motion.positions.col(i).head<3>();
    const double moment_Nm = force[4] + base_m.z() * force[0] - (base_m.x() - heel_m) * force[2];
    if (on_heel) {
      EXPECT_NEAR(moment_Nm, 0, 1e-3 * weight_N) << motion.time_s(i);
    } else {
      // Ahead of the heel, times the normal force: the foot is 0.2 m long and must not tip.
      const double ahead_Nm = -moment_Nm;
      EXPECT_GE(ahead_Nm, 0.0) << motion.time_s(i);
      EXPECT_LE(ahead_Nm, 0.2 * force[2]) << motion.time_s(i);
    }
  }
}

TEST_F(FlipMotion, StandsStillAndTurnsOnce) {
  const Index last = motion.samples() - 1;
  EXPECT_LT(motion.velocities.col(0).norm(), 1e-9);
  EXPECT_LT(motion.velocities.col(last).norm(), 1e-9);
  double turned_rad = 0;  // Simpson's neighbour, the trapezoid: 1e-5 a step at most (see above).
  for (Index i = 1; i < motion.samples(); ++i) {
    const double h = motion.time_s(i) - motion.time_s(i - 1);
    turned_rad +=
        0.5 * h * (motion.velocities(kPitchRate, i) + motion.velocities(kPitchRate, i - 1));
  }
  const auto pitch_rad = [&](Index i) {
    const VectorXd position = motion.positions.col(i);
    return 2 * std::atan2(position[5], position[3]);
  };
  const double apart_rad = pitch_rad(last) - pitch_rad(0);
  EXPECT_NEAR(std::remainder(turned_rad - apart_rad, 2 * std::numbers::pi), 0, 1e-3);
  EXPECT_GT(turned_rad, 1.5 * std::numbers::pi);
  for (Index i = 0; i < motion.samples(); ++i) {
    set(i);
    for (std::size_t contact = 0; contact < robot.contacts.size(); ++contact) {
      EXPECT_GT(height_m(contact), -kOnGround_m) << motion.time_s(i);
    }
  }
}

TEST_F(FlipMotion, TouchDownIsARigidImpact) {
  // Rotors as they reflect at the joints in this posture.
  hopper::WholeBody body(robot);
  ASSERT_TRUE(body.set(motion.positions.col(touch_down), motion.velocities.col(touch_down)));
  Eigen::MatrixXd with(9, 9);
  Eigen::MatrixXd without(9, 9);
  body.mass_matrix(with);
  set(touch_down);
  dynamics::mass_matrix(state, without);
  dynamics::Tree tree = robot.tree;
  for (std::size_t joint = 1; joint < tree.bodies.size(); ++joint) {
    const Index row = state.joint_row(joint);
    tree.bodies[joint].joint.reflected_inertia += with(row, row) - without(row, row);
  }
  dynamics::TreeState landing(tree);
  landing.set(motion.positions.col(touch_down - 1), motion.velocities.col(touch_down - 1));
  std::vector<test::Contact> contacts;
  for (const hopper::ContactPoint& contact : robot.contacts) {
    EXPECT_LT(dynamics::point_velocity_m_s(landing, contact.point).z(), 0);
    contacts.push_back({contact.point, Vector3d::UnitZ(), contact.friction_coefficient, 0});
  }
  const test::Impact impact = test::impact(landing, contacts);
  ASSERT_EQ(impact.status, test::ImpactStatus::kSolved);
  EXPECT_LT((impact.velocity - motion.velocities.col(touch_down)).cwiseAbs().maxCoeff(), 1e-5);
  EXPECT_EQ(motion.positions.col(touch_down), motion.positions.col(touch_down - 1));
}

TEST_F(FlipMotion, KeepsItsJointsRanges) {
  for (std::size_t body = 1; body < robot.tree.bodies.size(); ++body) {
    const dynamics::JointLimits& limits = robot.tree.bodies[body].joint.limits;
    const auto row = motion.positions.row(6 + static_cast<Index>(body));
    EXPECT_GE(row.minCoeff(), limits.position_min);
    EXPECT_LE(row.maxCoeff(), limits.position_max);
  }
}

}  // namespace
}  // namespace torquewright
