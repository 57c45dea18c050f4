// SPDX-License-Identifier: Apache-2.0
// Oracles: differences over a short time of places that dynamics/ gives, along motions of constant
// acceleration; the impact of rigid bodies.
#include "hopper/tracking/operational/task_rows.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>

#include "dynamics/point.hpp"
#include "dynamics/position_step.hpp"
#include "hopper/tracking/contact_rows.hpp"
#include "hopper/tracking/error_space.hpp"
#include "hopper/tracking/impact_invariant.hpp"
#include "tests/dynamics/random_numbers.hpp"
#include "tests/hopper/tracking/closed_loop.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kBent_rad = 1e-3;

TouchingPoints points(const Robot& robot, bool touch) {
  return TouchingPoints::Constant(static_cast<Index>(robot.contacts.size()), touch);
}

/// A robot near its crouch, moving, and a motion that wants it elsewhere.
class TaskRowsOf : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    oracles::Dice dice(11);
    const Index n = robot.tree.velocity_size();
    VectorXd still = dynamics::zero_position(robot.tree);
    for (Index i = robot.tree.base_velocity_size(); i < n; ++i) {
      const Index at = still.size() - n + i;
      const auto& limits =
          robot.tree.bodies[static_cast<std::size_t>(i - robot.tree.base_velocity_size()) + 1]
              .joint.limits;
      still[at] = 0.5 * (limits.position_min + limits.position_max);
    }
    const auto away = [&](double by) {
      VectorXd way(n), out(still.size());
      for (Index i = 0; i < n; ++i) way[i] = by * ::torquewright::test::uniform(dice, -1, 1);
      dynamics::step_position(robot.tree, still, way, 1.0, out);
      return out;
    };
    const auto drawn = [&](double size) {
      VectorXd out(n);
      for (Index i = 0; i < n; ++i) out[i] = size * ::torquewright::test::uniform(dice, -1, 1);
      return out;
    };
    position = away(0.1);
    velocity = drawn(1.0);
    acceleration = drawn(5.0);
    wanted = {away(0.1), drawn(1.0), drawn(5.0), VectorXd()};
  }

  /// All kinds, with no point touching.
  std::vector<OperationalTask> tasks() const {
    return {{.kind = TaskKind::kCenterOfMass},
            {.kind = TaskKind::kBaseAttitude},
            {.kind = TaskKind::kPoint, .of = 0},
            {.kind = TaskKind::kJoint, .of = 1}};
  }

  /// Rates of all tasks in a state, by what dynamics/ says of bodies and points.
  VectorXd rates(const VectorXd& at, const VectorXd& moving) {
    const bool is_planar = robot.tree.base == dynamics::BaseKind::kPlanar;
    WholeBody body(robot);
    EXPECT_TRUE(body.set(at, moving));
    const Vector3d center = body.centroid().velocity_m_s;
    const Vector3d point =
        dynamics::point_velocity_m_s(body.state(), robot.contacts[0].point) - center;
    const Index first = robot.tree.base_velocity_size();
    VectorXd out(is_planar ? 6 : 10);
    if (is_planar) {
      out << center.x(), center.z(), moving[2], point.x(), point.z(), moving[first];
    } else {
      out << center, moving.segment<3>(3), point, moving[first];
    }
    return out;
  }

  Index place_of(std::size_t joint) const {
    return position.size() - static_cast<Index>(robot.tree.bodies.size() - joint);
  }

  Robot robot = test::robot_of(GetParam());
  VectorXd position, velocity, acceleration;
  ReferenceInstant wanted;
};

// d/dt (J v) = J a + J' v, by central differences along the motion with that acceleration.
TEST_P(TaskRowsOf, HaveTheRatesAndTheBiasThatBodiesHave) {
  TaskFrame frame(robot);
  ASSERT_TRUE(frame.set(wanted, points(robot, false), position, velocity));
  TaskRows rows;
  frame.rows(tasks(), rows);
  const AlignedError seen = aligned_error(robot.tree, wanted, position, velocity);
  const VectorXd now = rates(seen.position, seen.velocity);
  EXPECT_LE((rows.jacobian * frame.velocity() - now).norm(), 1e-12 * (1.0 + now.norm()));
  constexpr double kStep_s = 1e-5;
  const auto moved = [&](double by_s) {
    VectorXd at(position.size());
    dynamics::step_position(robot.tree, seen.position, seen.velocity + 0.5 * by_s * acceleration,
                            by_s, at);
    return rates(at, seen.velocity + by_s * acceleration);
  };
  const VectorXd change = (moved(kStep_s) - moved(-kStep_s)) / (2.0 * kStep_s);
  const VectorXd made = rows.jacobian * acceleration + rows.bias;
  // Rates of 1 lose 1e-15 of them over the step, and its square is the differences' own.
  EXPECT_LE((change - made).norm(), 1e-8 * (1.0 + made.norm()));
  EXPECT_GT(rows.bias.norm(), 1e-2);
}

// Errors of rates are those of the wanted body and the seen one; errors of places those of its
// parts from their centre of mass. Nothing is wanted of a robot that does what the motion does.
TEST_P(TaskRowsOf, WantNothingOfARobotThatFollows) {
  TaskFrame frame(robot);
  ASSERT_TRUE(frame.set(wanted, points(robot, false), wanted.position, wanted.velocity));
  TaskRows rows;
  frame.rows(tasks(), rows);
  EXPECT_LE(rows.place_error.norm(), 1e-12);
  EXPECT_LE(rows.rate_error.norm(), 1e-12);
  EXPECT_LE((rows.jacobian * wanted.acceleration + rows.bias - rows.acceleration).norm(),
            1e-10 * (1.0 + rows.acceleration.norm()));
}

// In stance a robot that was carried along the ground as a whole lacks nothing; one whose mass is
// carried from above its feet lacks just that.
TEST_P(TaskRowsOf, CountFromTheFeetThatStand) {
  TaskFrame frame(robot);
  VectorXd carried = wanted.position;
  carried[0] += 0.7;
  const std::vector<OperationalTask> center{{.kind = TaskKind::kCenterOfMass}};
  TaskRows rows;
  ASSERT_TRUE(frame.set(wanted, points(robot, true), carried, wanted.velocity));
  frame.rows(center, rows);
  EXPECT_LE(rows.place_error.norm(), 1e-12);
  ASSERT_TRUE(frame.set(wanted, points(robot, true), position, velocity));
  frame.rows(center, rows);
  EXPECT_GT(rows.place_error.norm(), 1e-3);
}

// An impulse on the points that land changes velocities by M^-1 J^T p; what is left of the error of
// all tasks' rates does not know it.
TEST_P(TaskRowsOf, LeaveNothingOfAnImpulse) {
  TaskFrame frame(robot);
  ASSERT_TRUE(frame.set(wanted, points(robot, false), position, velocity));
  TaskRows rows;
  frame.rows(tasks(), rows);
  const ContactRows landing = contact_rows(robot, frame.body().state(), points(robot, true));
  const VectorXd impulse = VectorXd::LinSpaced(landing.jacobian.rows(), -1.0, 2.0);
  const VectorXd jump = frame.mass().llt().solve(landing.jacobian.transpose() * impulse);
  ASSERT_GT((rows.jacobian * jump).norm(), 0.1);
  const ImpactMap map = impact_map(frame.mass(), landing.jacobian, rows.jacobian);
  VectorXd before = rows.rate_error, after = rows.rate_error - rows.jacobian * jump;
  const ImpactOptions options{.handling = ImpactHandling::kInvariant, .window_s = 1.0};
  handle_impact(options, 0.0, map, before);
  handle_impact(options, 0.0, map, after);
  EXPECT_LE((after - before).norm(), 1e-9 * (rows.jacobian * jump).norm());
}

// Eq. (9) by its definition, of a robot whose first drive is taken away: its joint stands still,
// the others' drives turn as they do, and points that touch move as they do as nearly as the base's
// velocity lets them. Tasks' rates are of that velocity.
TEST_P(TaskRowsOf, TakeOutTheRatesOfRigidSprings) {
  ASSERT_FALSE(robot.drivetrains.front().joints.empty());
  const std::vector<std::size_t> loose = robot.drivetrains.front().joints;
  robot.drivetrains.erase(robot.drivetrains.begin());
  std::vector<RigidJoint> rigid;
  for (const std::size_t joint : loose) {
    rigid.push_back({.is_link = false, .of = joint});
    const Index at = place_of(joint);
    wanted.position[at] = position[at];  // there is nothing to straighten
  }
  TaskFrame frame(robot, rigid);
  ASSERT_TRUE(frame.set(wanted, points(robot, true), position, velocity));
  const Index base = robot.tree.base_velocity_size();
  const VectorXd change = frame.rigid_velocity() - frame.velocity();
  for (Index row = base; row < change.size(); ++row) {
    const auto joint = static_cast<std::size_t>(row - base) + 1;
    const bool is_spring = std::find(loose.begin(), loose.end(), joint) != loose.end();
    EXPECT_NEAR(change[row], is_spring ? -frame.velocity()[row] : 0.0, 1e-12);
  }
  EXPECT_GT(change.tail(change.size() - base).norm(), 0.1);
  // Least squares: what is left is square to what the base can do.
  const Eigen::MatrixXd feet = frame.contacts().jacobian;
  EXPECT_LE((feet.leftCols(base).transpose() * (feet * change)).norm(), 1e-9);
  TaskRows held, loosely;
  frame.rows(tasks(), held);
  TaskFrame without(robot);
  ASSERT_TRUE(without.set(wanted, points(robot, true), position, velocity));
  without.rows(tasks(), loosely);
  EXPECT_LE((held.rate_error - loosely.rate_error + held.jacobian * change).norm(), 1e-12);
  EXPECT_GT((held.rate_error - loosely.rate_error).norm(), 0.01);
}

// What is seen of a robot with bent springs is one whose springs stand as the motion has them,
// whose drives stand as they do, and whose foot, one body, has not moved but as a whole.
TEST_P(TaskRowsOf, SeeRigidSpringsAsTheMotionHasThem) {
  const std::vector<std::size_t> loose = robot.drivetrains.front().joints;
  robot.drivetrains.erase(robot.drivetrains.begin());
  std::vector<RigidJoint> rigid;
  for (const std::size_t joint : loose) {
    rigid.push_back({.is_link = false, .of = joint});
    position[place_of(joint)] = wanted.position[place_of(joint)] + kBent_rad;
  }
  TaskFrame frame(robot, rigid);
  ASSERT_TRUE(frame.set(wanted, points(robot, true), position, velocity));
  for (std::size_t joint = 1; joint < robot.tree.bodies.size(); ++joint) {
    const bool is_spring = std::find(loose.begin(), loose.end(), joint) != loose.end();
    const Index at = place_of(joint);
    EXPECT_NEAR(frame.body().state().joint_position(joint),
                is_spring ? wanted.position[at] : position[at], 1e-9);
  }
  const AlignedError seen = aligned_error(robot.tree, wanted, position, velocity);
  WholeBody bent(robot);
  ASSERT_TRUE(bent.set(seen.position, seen.velocity));
  const auto way = [&](const WholeBody& body) {
    return Vector3d(dynamics::point_position_m(body.state(), robot.contacts.back().point) -
                    dynamics::point_position_m(body.state(), robot.contacts.front().point));
  };
  // The base makes up for them to the first order.
  EXPECT_LE((way(frame.body()) - way(bent)).norm(), 10.0 * kBent_rad * kBent_rad);
  if (robot.contacts.size() > 1) {
    EXPECT_GT(way(bent).norm(), 0.05);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, TaskRowsOf, testing::Values("hopper.json", "planar_leg.json"),
                         [](const auto& one) {
                           return std::string(one.param).substr(0,
                                                                std::string(one.param).find('.'));
                         });

}  // namespace
}  // namespace torquewright::hopper
