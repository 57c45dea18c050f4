// SPDX-License-Identifier: Apache-2.0
// Oracles: counting (what a foot on the ground leaves free), the contact points of a state that was
// moved by an error, and symmetry: flat ground is the same everywhere.
#include "hopper/tracking/error_space.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "dynamics/position_step.hpp"
#include "tests/hopper/tracking/closed_loop.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

class ErrorSpaces : public testing::Test {
 protected:
  /// Of a mode of the flip in its middle.
  ErrorSpace space_of(std::size_t mode) {
    const ContactMode& one = planned.reference->modes()[mode];
    planned.reference->at(0.5 * (one.from_s + one.until_s), at);
    touches = one.touches;
    return error_space(body, at.position, at.velocity, touches).value();
  }
  void set() { ASSERT_TRUE(body.set(at.position, at.velocity)); }

  test::PlannedMotion planned{"hopper.json", "hopper_flip.csv"};
  WholeBody body{planned.robot};
  ReferenceInstant at;
  TouchingPoints touches;
};

// Of 9 - 3 (place and heading) directions and 9 velocities the whole foot takes height and two
// tilts, and all of its 6 velocities; the heel height and one tilt, and 5.
TEST_F(ErrorSpaces, LeaveFreeWhatTheGroundDoes) {
  const Index free[] = {3 + 3, 4 + 4, 6 + 9, 3 + 3};
  for (std::size_t mode = 0; mode < 4; ++mode) {
    const ErrorSpace space = space_of(mode);
    EXPECT_EQ(space.from_free.cols(), free[mode]);
    const MatrixXd both = space.to_free * space.from_free;
    EXPECT_LT((both - MatrixXd::Identity(free[mode], free[mode])).norm(), 1e-11);
  }
}

TEST_F(ErrorSpaces, FreeErrorsKeepThePointsOnTheGround) {
  constexpr double kSmall = 1e-5;  // What is left goes with its square, times some 100/s.
  for (const std::size_t mode : {0u, 1u, 3u}) {
    const ErrorSpace space = space_of(mode);
    set();
    const VectorXd before =
        contact_rows(planned.robot, body.state(), touches).jacobian * body.state().velocity();
    for (Index column = 0; column < space.from_free.cols(); ++column) {
      const VectorXd error = kSmall * space.from_free.col(column);
      VectorXd moved(10);
      dynamics::step_position(planned.robot.tree, at.position, error.head(9), 1.0, moved);
      ASSERT_TRUE(body.set(moved, at.velocity + error.tail(9)));
      const ContactRows rows = contact_rows(planned.robot, body.state(), touches);
      EXPECT_LT((rows.jacobian * body.state().velocity() - before).norm(), 1e-7);
      for (Index i = 0; i < touches.size(); ++i) {
        if (!touches[i]) continue;
        const auto& point = planned.robot.contacts[static_cast<std::size_t>(i)].point;
        EXPECT_LT(std::abs(dynamics::point_position_m(body.state(), point).z()), 1e-7);
      }
    }
  }
}

TEST_F(ErrorSpaces, ImpulsesOfTheGroundAreNoErrors) {
  for (const std::size_t mode : {0u, 1u, 3u}) {
    const ErrorSpace space = space_of(mode);
    set();
    MatrixXd mass(9, 9);
    body.mass_matrix(mass);
    const MatrixXd J = contact_rows(planned.robot, body.state(), touches).jacobian;
    MatrixXd answer = MatrixXd::Zero(18, J.rows());
    answer.bottomRows(9) = mass.llt().solve(J.transpose());
    EXPECT_LT((space.to_free * answer).norm(), 1e-11 * answer.norm());
  }
}

// A robot elsewhere and facing elsewhere: no error, by rotations of Eigen's own.
TEST_F(ErrorSpaces, PlaceAndHeadingAreNoErrors) {
  const dynamics::Tree& tree = planned.robot.tree;
  for (std::size_t mode = 0; mode < 4; ++mode) {
    const ErrorSpace space = space_of(mode);
    for (const double heading_rad : {1e-6, 0.3, -2.0}) {
      const Eigen::Quaterniond turn(Eigen::AngleAxisd(heading_rad, Eigen::Vector3d::UnitZ()));
      const Eigen::Quaterniond base =
          turn * Eigen::Quaterniond(at.position[3], at.position[4], at.position[5], at.position[6]);
      VectorXd position = at.position, velocity = at.velocity;
      position[0] += 3.0;
      position[1] -= 2.0;
      position.segment<4>(3) << base.w(), base.x(), base.y(), base.z();
      velocity.head<3>() = turn * at.velocity.head<3>();
      EXPECT_LT(aligned_error(tree, at, position, velocity).error.norm(), 1e-13);
      if (std::abs(heading_rad) > 1e-3) continue;
      // To first order the space says the same of the plain difference.
      VectorXd error(18);
      dynamics::position_difference(tree, at.position, position, error.head(9));
      error.tail(9) = velocity - at.velocity;
      EXPECT_LT((space.to_free * error).norm(), 1e-10);
    }
  }
}

TEST_F(ErrorSpaces, OtherErrorsPassTheAlignment) {
  (void)space_of(2);
  VectorXd way = VectorXd::LinSpaced(9, 0.01, 0.09), position(10);
  way[0] = way[1] = 0.0;
  set();
  const VectorXd heading = unfelt_directions(body.state()).col(2);
  way -= heading * heading.dot(way);
  dynamics::step_position(planned.robot.tree, at.position, way, 1.0, position);
  const VectorXd error = aligned_error(planned.robot.tree, at, position, at.velocity).error;
  EXPECT_LT((error.head(9) - way).norm(), 1e-3 * way.norm());  // of second order in 0.1 rad
  EXPECT_LT(error.tail(9).norm(), 0.02 * at.velocity.norm());
}

TEST(UnfeltDirections, AreAsManyAsTheBaseHas) {
  const Robot rabbit = test::robot_of("rabbit.json");
  dynamics::TreeState planar(rabbit.tree);
  EXPECT_EQ(unfelt_directions(planar), MatrixXd::Identity(7, 1));
  dynamics::Tree fixed = rabbit.tree;
  fixed.base = dynamics::BaseKind::kFixed;
  EXPECT_EQ(unfelt_directions(dynamics::TreeState(fixed)).cols(), 0);
}

}  // namespace
}  // namespace torquewright::hopper
