// SPDX-License-Identifier: Apache-2.0
// Where the turning view has a robot's bodies. Oracle: a planar leg in closed form.
#include "src/report/turning/body_poses.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/model/robot_spec.hpp"

namespace torquewright::report {
namespace {

using Eigen::Vector3d;

// A float's rounding at some metres. Four parts rounded by half a part each: a quaternion off by
// one part, a turn by two, a matrix's norm by the root of two times that.
constexpr double kPlace_m = 1e-6;
const double kTurn = 2.0 * std::sqrt(2.0) / kWholeTurn;

Eigen::Matrix3d about_y(double angle_rad) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  return (Eigen::Matrix3d() << c, 0, s, 0, 1, 0, -s, 0, c).finished();
}

TEST(BodyPoses, OfAPlanarLegAreThoseOfItsFormula) {
  const hopper::ReadRobot read =
      hopper::read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/planar_leg.json");
  constexpr double kThigh_m = 0.209;  // hip to knee, as the document has it
  Eigen::MatrixXd positions(5, 3);    // x, z, pitch, hip, knee
  positions.col(0) << 0.0, 0.35, 0.0, -0.7, 1.5;
  positions.col(1) << 1.2, 0.6, 2.9, -1.0, 2.2;
  positions.col(2) << -3.0, 0.4, -7.5, 0.4, 0.3;
  const BodyPoses poses = body_poses(read.robot, positions);
  for (Eigen::Index i = 0; i < positions.cols(); ++i) {
    const auto q = positions.col(i);
    const Vector3d trunk(q[0], 0.0, q[1]);
    const Eigen::Matrix3d thigh = about_y(q[2] + q[3]);
    const Eigen::Matrix3d shank = about_y(q[2] + q[3] + q[4]);
    const Vector3d knee = trunk + thigh * Vector3d(0.0, 0.0, -kThigh_m);
    EXPECT_LT((poses.place_m(0, i) - trunk).norm(), kPlace_m);
    EXPECT_LT((poses.place_m(1, i) - trunk).norm(), kPlace_m);
    EXPECT_LT((poses.place_m(2, i) - knee).norm(), kPlace_m);
    EXPECT_LT((poses.rotation(0, i) - about_y(q[2])).norm(), kTurn);
    EXPECT_LT((poses.rotation(1, i) - thigh).norm(), kTurn);
    EXPECT_LT((poses.rotation(2, i) - shank).norm(), kTurn);
    const Vector3d mass_kg_m = 3.3 * trunk + 0.634 * (trunk + thigh * Vector3d(0, 0, -0.02)) +
                               0.064 * (knee + shank * Vector3d(0, 0, -0.061));
    EXPECT_LT((poses.center_of_mass_m(i) - mass_kg_m / (3.3 + 0.634 + 0.064)).norm(), kPlace_m);
  }
}

}  // namespace
}  // namespace torquewright::report
