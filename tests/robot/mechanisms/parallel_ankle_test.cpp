// SPDX-License-Identifier: Apache-2.0
#include "robot/mechanisms/parallel_ankle.hpp"

#include <gtest/gtest.h>

#include "tests/robot/mechanisms/ankles.hpp"
#include "tests/robot/mechanisms/derivatives.hpp"
#include "tests/robot/mechanisms/joint_position.hpp"
#include "tests/robot/mechanisms/loop_newton.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Vector2d;
using oracles::Dice;
using test::margin_of;
using test::pair_of;
using test::plain_ankle;
using test::uniform;

// Roundings of some ten operations over the least slope of the loops that the draws allow.
constexpr double kSameAngle = 1e-11;

bool is_far_from_singular(const ParallelAnkle& ankle, const SmallVector& q) {
  for (const MechanismMargin& margin : ankle.margins(q)) {
    if (margin.name.find("dead") != std::string::npos && margin.value < 0.3) return false;
    if (margin.name == "least_lever" && margin.value < 0.01) return false;
    if (margin.name.find("reach") != std::string::npos && margin.margin < 0.005) return false;
  }
  return true;
}

// Oracle: Newton on the loop equations, written apart, for the actuators and for the joints;
// central differences for Jacobian and rate.
TEST(ParallelAnkle, AgreesWithNewtonOnItsLoops) {
  Dice dice(3);
  int compared = 0, negative_branches = 0;
  for (int i = 0; i < 2000; ++i) {
    const ParallelAnkleGeometry geometry = test::askew_ankle(dice);
    const ParallelAnkle ankle(geometry);
    const SmallVector q = pair_of(uniform(dice, -0.6, 0.5), uniform(dice, -0.4, 0.4));
    const SmallVector v = pair_of(uniform(dice, -2, 2), uniform(dice, -2, 2));
    const auto at = ankle.transfer(q, v);
    if (!at || !is_far_from_singular(ankle, q)) continue;
    ++compared;
    negative_branches += geometry.rods[0].branch < 0 || geometry.rods[1].branch < 0;
    // From starts beside the answers: which of its two answers Newton finds is not the question.
    const Vector2d beside(uniform(dice, -0.05, 0.05), uniform(dice, -0.05, 0.05));
    const auto actuators =
        test::solve_loops(geometry, q, false, Vector2d(at->actuator_position_rad) + beside);
    ASSERT_TRUE(actuators);
    EXPECT_LE((*actuators - Vector2d(at->actuator_position_rad)).norm(), kSameAngle);
    const auto joints =
        test::solve_loops(geometry, at->actuator_position_rad, true, Vector2d(q) + beside);
    ASSERT_TRUE(joints);
    EXPECT_LE((*joints - Vector2d(q)).norm(), kSameAngle);
    const auto forward = test::joint_position_rad(ankle, at->actuator_position_rad,
                                                  SmallVector(Vector2d(q) + beside));
    ASSERT_TRUE(forward);
    EXPECT_LE((*forward - q).norm(), kSameAngle);
    test::expect_derivatives(ankle, q, v);
  }
  EXPECT_GT(compared, 1000);
  EXPECT_GT(negative_branches, 300);
}

// Oracle: levers by hand. Upright rods: a foot's pin at (-h, +-y) rises by h pitch less y roll ...
// so that cranks of length r turn by h/r pitch +- y/r roll.
TEST(ParallelAnkle, HasTheLeversRatiosWhereRodsStandUpright) {
  const ParallelAnkle ankle(plain_ankle(0.06, 0.05, 0.04));
  const auto at = ankle.transfer(pair_of(0, 0), pair_of(0, 0));
  ASSERT_TRUE(at);
  EXPECT_LE(at->actuator_position_rad.norm(), 1e-14);
  Eigen::Matrix2d byhand;
  byhand << 5.0 / 6, 4.0 / 6, 5.0 / 6, -4.0 / 6;
  EXPECT_LE((at->jacobian - byhand).norm(), 1e-13);
}

// Oracle: geometry of parallels. Crank and foot's lever alike make parallelograms in the plane of
// pitch: cranks turn as the foot does.
TEST(ParallelAnkle, FollowsPitchOneToOneWhereItIsTwoParallelograms) {
  const ParallelAnkle ankle(plain_ankle(0.05, 0.05, 0.05));
  for (double pitch = -1.5; pitch < 1.5; pitch += 0.1) {
    const auto at = ankle.transfer(pair_of(pitch, 0), pair_of(3, 0));
    ASSERT_TRUE(at) << pitch;
    EXPECT_LE((at->actuator_position_rad - pair_of(pitch, pitch)).norm(), 1e-12);
    EXPECT_NEAR(at->jacobian(0, 0), 1, 1e-12);
    EXPECT_LE((at->jacobian_rate_1_s * pair_of(3, 0)).norm(), 1e-10);
    // The crank's end is as far from being in line with its rod as pitch is from a right angle.
    const auto margins = ankle.margins(pair_of(pitch, 0));
    EXPECT_NEAR(margin_of(margins, "crank_1_dead_centre")->value, M_PI / 2 - std::abs(pitch), 1e-7);
    EXPECT_NEAR(margin_of(margins, "rod_1_tilt_at_foot")->value, 0, 1e-12);
  }
  for (const double upright : {M_PI / 2, -M_PI / 2}) {  // all links in line
    EXPECT_FALSE(ankle.transfer(pair_of(upright, 0), pair_of(0, 0)));
  }
}

// Oracle: distances by hand. Reach ends where the foot's pin is as far from the actuator as crank
// and rod together; with the crank's pin behind a shortened rod, at their difference.
TEST(ParallelAnkle, NamesWhatIsBeyondReach) {
  ParallelAnkleGeometry geometry = plain_ankle(0.05, 0.05, 0.05);
  const double distance = std::hypot(0.05, 0.17);  // at zero, actuator 1 to its pin on the foot
  geometry.rods[0].rod_length_m = distance - 0.05 - 1e-3;
  const auto short_rod = ParallelAnkle(geometry).margins(pair_of(0, 0));
  EXPECT_NEAR(margin_of(short_rod, "rod_1_reach_folded")->margin, -1e-3, 1e-14);
  EXPECT_FALSE(margin_of(short_rod, "crank_1_dead_centre"));
  EXPECT_FALSE(margin_of(short_rod, "least_lever"));
  EXPECT_FALSE(ParallelAnkle(geometry).transfer(pair_of(0, 0), pair_of(0, 0)));
  geometry.rods[0].rod_length_m = distance + 0.05 - 1e-3;
  const auto long_rod = ParallelAnkle(geometry).margins(pair_of(0, 0));
  EXPECT_NEAR(margin_of(long_rod, "rod_1_reach_stretched")->margin, 1e-3, 1e-14);
  EXPECT_TRUE(ParallelAnkle(geometry).transfer(pair_of(0, 0), pair_of(0, 0)));
}

// Oracles by hand: rods in one plane with the pitch axis (no half distance) leave roll free; with
// levers h and half distances y the rods' weakest direction has sqrt 2 times the smaller.
TEST(ParallelAnkle, NamesTheFootThatRodsCannotHold) {
  const ParallelAnkle loose(plain_ankle(0.05, 0.05, 0));
  EXPECT_FALSE(loose.transfer(pair_of(0.2, 0), pair_of(0, 0)));
  EXPECT_NEAR(margin_of(loose.margins(pair_of(0.2, 0)), "least_lever")->margin, 0, 1e-15);
  const ParallelAnkle narrow(plain_ankle(0.05, 0.05, 0.01));
  EXPECT_NEAR(margin_of(narrow.margins(pair_of(0, 0)), "least_lever")->margin, 0.01 * std::sqrt(2),
              1e-14);
}

// Oracle by hand: a roll tilts the foot's pins by itself, a shift y' of the crank's pin along its
// axis tilts an upright rod by atan(y'/length).
TEST(ParallelAnkle, MeasuresTheTiltOfBallJoints) {
  ParallelAnkleGeometry geometry = plain_ankle(0.06, 0.05, 0.04);
  geometry.rods[0].actuator_center_m.y() += 0.03;
  geometry.rods[0].rod_length_m = std::hypot(0.17, 0.03);
  const auto margins = ParallelAnkle(geometry).margins(pair_of(0, 0));
  EXPECT_NEAR(margin_of(margins, "rod_1_tilt_at_crank")->value, std::atan2(0.03, 0.17), 1e-14);
  EXPECT_NEAR(margin_of(margins, "rod_1_tilt_at_foot")->margin, 0.6 - std::atan2(0.03, 0.17),
              1e-14);
  EXPECT_NEAR(margin_of(margins, "rod_2_tilt_at_foot")->value, 0, 1e-14);
  geometry = plain_ankle(0.06, 0.05, 0);  // rods in the plane of pitch: roll tilts the pins alone
  const auto rolled = ParallelAnkle(geometry).margins(pair_of(0, 0.3));
  EXPECT_NEAR(margin_of(rolled, "rod_1_tilt_at_foot")->value, 0.3, 1e-14);
  EXPECT_NEAR(margin_of(rolled, "rod_1_tilt_at_crank")->value, 0, 1e-14);
}

// Oracle: statics, without a Jacobian: force along each rod, its moment about each joint's axis
// against its moment about the actuator's.
TEST(ParallelAnkle, BearsTorquesByForcesAlongItsRods) {
  Dice dice(8);
  for (int i = 0; i < 200; ++i) {
    const ParallelAnkleGeometry geometry = test::askew_ankle(dice);
    const SmallVector q = pair_of(uniform(dice, -0.3, 0.3), uniform(dice, -0.3, 0.3));
    const auto at = ParallelAnkle(geometry).transfer(q, pair_of(0, 0));
    if (!at || !is_far_from_singular(ParallelAnkle(geometry), q)) continue;
    const SmallVector torque = pair_of(uniform(dice, -100, 100), uniform(dice, -100, 100));
    Vector2d about_joints(0, 0);
    const Eigen::AngleAxisd pitch(q[0], geometry.first.axis), roll(q[1], geometry.second.axis);
    const Eigen::Matrix3d cross = geometry.first.R_PB * pitch.toRotationMatrix();
    const Eigen::Vector3d second_m = geometry.first.p_PB_m + cross * geometry.second.p_PB_m;
    for (std::size_t k = 0; k < 2; ++k) {
      const AnkleRod& rod = geometry.rods[k];
      const auto index = static_cast<Eigen::Index>(k);
      const Eigen::Vector3d crank =
          Eigen::AngleAxisd(at->actuator_position_rad[index], rod.actuator_axis) * rod.crank_m;
      const Eigen::Vector3d pin =
          second_m + cross * geometry.second.R_PB * roll.toRotationMatrix() * rod.foot_attachment_m;
      const Eigen::Vector3d along = (pin - rod.actuator_center_m - crank).normalized();
      const double force_N = torque[index] / rod.actuator_axis.dot(crank.cross(along));
      const Eigen::Vector3d first_axis = geometry.first.R_PB * geometry.first.axis;
      const Eigen::Vector3d second_axis = cross * geometry.second.R_PB * geometry.second.axis;
      about_joints[0] += force_N * first_axis.dot((pin - geometry.first.p_PB_m).cross(along));
      about_joints[1] += force_N * second_axis.dot((pin - second_m).cross(along));
    }
    const Vector2d ours = joint_torque_Nm(*at, torque);
    EXPECT_LE((ours - about_joints).norm(), 1e-10 * (1 + ours.norm()));
    EXPECT_LE((actuator_torque_Nm(*at, ours) - torque).norm(), 1e-9 * (1 + ours.norm()));
  }
}

// Oracle: kinetic energy of the rotors, 1/2 sum I theta'^2; its rate is the power of the torque.
TEST(ParallelAnkle, ReflectsItsRotorsInertia) {
  const ParallelAnkle ankle(plain_ankle(0.06, 0.05, 0.04));
  const SmallVector q = pair_of(-0.5, 0.2), v = pair_of(3, -2), a = pair_of(40, 70);
  const SmallVector rotors = pair_of(0.0128, 0.02);
  const auto at = ankle.transfer(q, v);
  ASSERT_TRUE(at);
  const SmallVector speeds = at->jacobian * v;
  EXPECT_NEAR(0.5 * v.dot(reflected_inertia_kg_m2(*at, rotors) * v),
              0.5 * (0.0128 * speeds[0] * speeds[0] + 0.02 * speeds[1] * speeds[1]), 1e-14);
  const auto energy = [&](double t) {
    const SmallVector there = q + v * t + a * (t * t / 2), then = v + a * t;
    const SmallVector turning = ankle.transfer(there, then)->jacobian * then;
    return 0.5 * (0.0128 * turning[0] * turning[0] + 0.02 * turning[1] * turning[1]);
  };
  const double h = 1e-5;
  EXPECT_NEAR(v.dot(rotor_torque_Nm(*at, rotors, v, a)), (energy(h) - energy(-h)) / (2 * h), 1e-6);
}

// Whatever it is asked for, it says so or gives numbers that are finite.
TEST(ParallelAnkle, HasNoForwardAnswerBeyondReach) {
  const ParallelAnkle ankle(plain_ankle(0.06, 0.05, 0.04));
  EXPECT_FALSE(test::joint_position_rad(ankle, pair_of(1.5, -1.5), pair_of(0, 0)));
  EXPECT_FALSE(ankle.transfer(pair_of(NAN, 0), pair_of(0, 0)));
}

}  // namespace
}  // namespace torquewright::hopper
