// SPDX-License-Identifier: Apache-2.0
// Where a foot comes down. Oracle: the robot carried along its velocity until the foot is at the
// height of the planned touch-down.
#include "hopper/tracking/touch_down.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "dynamics/point.hpp"
#include "dynamics/position_step.hpp"
#include "tests/hopper/tracking/closed_loop.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

class LandingPlace : public testing::Test {
 protected:
  /// Middle of the points that come down, with the robot moved by an error and then carried on.
  Vector3d middle_m(const VectorXd& error, double later_s) {
    VectorXd moved(10), carried(10);
    const dynamics::Tree& tree = planned.robot.tree;
    dynamics::step_position(tree, before.position, error.head(9), 1.0, moved);
    dynamics::step_position(tree, moved, before.velocity, later_s, carried);
    EXPECT_TRUE(body.set(carried, before.velocity));
    Vector3d sum_m = Vector3d::Zero();
    for (Index i = 0; i < landing.size(); ++i) {
      if (!landing[i]) continue;
      sum_m += dynamics::point_position_m(
          body.state(), planned.robot.contacts[static_cast<std::size_t>(i)].point);
    }
    return sum_m / static_cast<double>(landing.count());
  }
  /// By bisection, the place at the moment at which it is as high as planned.
  Vector3d place_m(const VectorXd& error) {
    const double height_m = middle_m(VectorXd::Zero(18), 0.0).z();
    double early_s = -1e-3, late_s = 1e-3;
    for (int i = 0; i < 60; ++i) {
      const double middle_s = 0.5 * (early_s + late_s);
      (middle_m(error, middle_s).z() > height_m ? early_s : late_s) = middle_s;
    }
    return middle_m(error, early_s);
  }

  test::PlannedMotion planned{"hopper.json", "hopper_flip.csv"};
  WholeBody body{planned.robot};
  DrivenState before;
  TouchingPoints landing;
};

TEST_F(LandingPlace, IsWhereItsWayMeetsTheGround) {
  constexpr double kSmall = 1e-6;
  const auto& modes = planned.reference->modes();
  ReferenceInstant at;
  planned.reference->at(std::nextafter(modes[2].until_s, modes[2].from_s), at);
  before = {at.position, at.velocity, at.drive_Nm};
  landing = modes[3].touches;
  const auto place = landing_place(body, before, modes[2].touches, landing);
  ASSERT_TRUE(place);
  for (Index i = 0; i < 9; ++i) {
    VectorXd error = VectorXd::Zero(18);
    error[i] = kSmall;
    const Vector3d ahead_m = place_m(error), behind_m = place_m(-error);
    const Eigen::Vector2d slope = (ahead_m - behind_m).head<2>() / (2.0 * kSmall);
    EXPECT_LT((slope - place->col(i)).norm(), 1e-4 * (1.0 + slope.norm())) << i;
  }
  EXPECT_TRUE(place->rightCols(9).isZero(0.0));
}

TEST_F(LandingPlace, OfWhatStandsIsNone) {
  const auto& modes = planned.reference->modes();
  ReferenceInstant at;
  planned.reference->at(0.5 * modes[0].until_s, at);
  const auto place = landing_place(body, {at.position, at.velocity, at.drive_Nm}, modes[0].touches,
                                   modes[0].touches);
  ASSERT_TRUE(place);
  EXPECT_TRUE(place->isZero(0.0));
}

}  // namespace
}  // namespace torquewright::hopper
