// SPDX-License-Identifier: Apache-2.0
// Shapes, scales and frame of the turning view. Oracles: volumes and inertias of solids by their
// formulas, the definition of base64 with its own examples, the geometry of a ball.
#include "src/report/turning/turning_view.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "robot/model/robot_spec.hpp"
#include "src/report/parts/base64.hpp"

namespace torquewright::report {
namespace {

using Eigen::Vector3d;

TEST(BodyShapes, CapsulesAreAsThickAsTheirMass) {
  // Of 2 kg a litre: the volume of a capsule, and of a ball.
  const double capsule_m3 = std::numbers::pi * 0.05 * 0.05 * (0.2 + 4.0 / 3.0 * 0.05);
  EXPECT_NEAR(capsule_radius_m(2000.0 * capsule_m3, 0.2), 0.05, 1e-12);
  EXPECT_NEAR(capsule_radius_m(2000.0 * 4.0 / 3.0 * std::numbers::pi * 1e-3, 0.0), 0.1, 1e-12);
  EXPECT_EQ(capsule_radius_m(0.0, 0.3), 0.0);
}

TEST(BodyShapes, BoxHasTheInertiaItIsMadeOf) {
  // Of a box with half lengths a, b, c: m (b^2 + c^2) / 3 and so on; turned by any rotation.
  const Vector3d half_m(0.19, 0.1, 0.05);
  const double mass_kg = 3.3;
  const Vector3d squares = half_m.cwiseAbs2();
  const Vector3d inertia = mass_kg / 3.0 * (Vector3d::Constant(squares.sum()) - squares);
  const Eigen::Matrix3d R =
      (Eigen::AngleAxisd(0.7, Vector3d::UnitX()) * Eigen::AngleAxisd(-0.4, Vector3d::UnitZ()))
          .matrix();
  dynamics::RigidInertia body{
      mass_kg, {0.01, 0.02, 0.03}, R * inertia.asDiagonal() * R.transpose()};
  const auto box = box_of_inertia(body);
  ASSERT_TRUE(box);
  EXPECT_NEAR(box->axes.determinant(), 1.0, 1e-12);
  // Corner by corner: each of the true box is one of the found.
  const Eigen::Matrix3d found = box->axes * box->half_m.asDiagonal();
  const Eigen::Matrix3d true_edges = R * half_m.asDiagonal();
  for (int i = 0; i < 3; ++i) {
    double nearest_m = 1.0;
    for (int k = 0; k < 3; ++k) {
      for (const double sign : {-1.0, 1.0}) {
        nearest_m = std::min(nearest_m, (true_edges.col(i) - sign * found.col(k)).norm());
      }
    }
    EXPECT_LT(nearest_m, 1e-9);
  }
  // No box has an axis's inertia greater than the other two's sum.
  body.inertia_kg_m2 = Vector3d(0.1, 0.1, 0.21).asDiagonal();
  EXPECT_FALSE(box_of_inertia(body));
}

TEST(ForceScale, HoldsABlowOf44Kilonewtons) {
  const ForceScale scale = force_scale({0.0, 300.0, 310.0, 290.0, 43900.0, 0.0});
  EXPECT_TRUE(scale.is_root);
  EXPECT_EQ(scale.share(43900.0), 1.0);
  EXPECT_NEAR(scale.share(43900.0 / 4.0), 0.5, 1e-12);
  EXPECT_NE(scale.words().find("43.9 kN"), std::string::npos) << scale.words();
}

TEST(ForceScale, IsInProportionUnlessABlowStandsOut) {
  EXPECT_FALSE(force_scale({100.0, 100.0, 799.0}).is_root);
  EXPECT_TRUE(force_scale({100.0, 100.0, 801.0}).is_root);
  const ForceScale even = force_scale({100.0, 200.0, 400.0});
  EXPECT_EQ(even.share(200.0), 0.5);
  EXPECT_NE(even.words().find("400 N, the others in proportion"), std::string::npos);
  EXPECT_EQ(force_scale({0.0, 0.0}).share(5.0), 0.0);
  EXPECT_EQ(force_scale({}).words(), "force of the ground");
}

/// The planar leg, upright and then jumping far, pushed once by 44 kN.
class LegView : public testing::Test {
 protected:
  TurningView view(double far_m) {
    Eigen::MatrixXd positions(5, 3);
    positions.col(0) << 0.0, 0.35, 0.0, -0.7, 1.5;
    positions.col(1) << 0.5 * far_m, 0.8, 1.0, -1.0, 2.2;
    positions.col(2) << far_m, 0.35, 6.28, -0.7, 1.5;
    series_ = {{"time_s", Vector3d(0, 1, 2)},
               {"toe_x_N", Vector3d(0, 0, -300)},
               {"toe_z_N", Vector3d(300, 0, 44000)},
               {"knee_position_rad", Vector3d(1.5, 2.2, 1.5)},
               {"knee_joint_torque_Nm", Vector3d::Zero()}};
    return turning_view({read_.robot, series_, samples_, forces_, scale_, 0.0}, positions,
                        Eigen::MatrixXd());
  }

  hopper::ReadRobot read_ =
      hopper::read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/planar_leg.json");
  hopper::Series series_;
  std::vector<Eigen::Index> samples_{0, 1, 2};
  std::vector<ForceColumns> forces_{{"toe_x_N", "toe_y_N", "toe_z_N"}};
  ForceScale scale_ = force_scale({300.0, std::hypot(300.0, 44000.0)});
};

TEST_F(LegView, HoldsBodiesAndTheGreatestArrow) {
  const TurningView near = view(0.4);
  EXPECT_FALSE(near.follows);
  const dynamics::BodyPoint& toe = read_.robot.contacts.front().point;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Vector3d foot = near.is.place_m(2, i) + near.is.rotation(2, i) * toe.p_B_m;
    for (const Vector3d& shown : {near.is.place_m(0, i), near.is.place_m(2, i), foot}) {
      EXPECT_LE((shown - near.center_m).norm(), near.radius_m);
    }
    const Vector3d force_N(series_[1].values[i], 0.0, series_[2].values[i]);
    if (force_N.isZero()) continue;
    const Vector3d tip =
        foot + near.longest_m * scale_.share(force_N.norm()) * force_N.normalized();
    EXPECT_LE((tip - near.center_m).norm(), near.radius_m);
  }
}

TEST_F(LegView, GoesAlongWithALongWay) {
  const TurningView far = view(20.0);
  EXPECT_TRUE(far.follows);
  EXPECT_LT(far.radius_m, 2.0);  // of the robot and its leap, not of the way
}

TEST_F(LegView, TellsWhatTheSeriesKnowsOfTheJoint) {
  const TurningView near = view(0.4);
  ASSERT_EQ(near.told.size(), 3u);
  EXPECT_TRUE(near.told[0].empty() && near.told[1].empty());
  ASSERT_EQ(near.told[2].size(), 2u);
  EXPECT_EQ(near.told[2][0].column, "knee_position_rad");
  EXPECT_EQ(near.told[2][1].words, "knee: joint torque");
}

TEST_F(LegView, GridIsARoundNumber) {
  TurningView any;
  any.size_m = 0.65;
  EXPECT_DOUBLE_EQ(grid_m(any), 0.2);
  any.size_m = 1.6;
  EXPECT_DOUBLE_EQ(grid_m(any), 0.5);
  any.size_m = 3.0;
  EXPECT_DOUBLE_EQ(grid_m(any), 1.0);
}

// RFC 4648, section 10.
TEST(Base64, IsThatOfItsDefinition) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

}  // namespace
}  // namespace torquewright::report
