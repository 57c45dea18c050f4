// SPDX-License-Identifier: Apache-2.0
// Oracles: Newton's equation row by row (inverse dynamics does not know the accelerations' law),
// the contact points' velocities along the motion, the rigid impact of test::impact() that was
// written apart, wider differences of higher order, and the engine's steps.
#include "hopper/tracking/linearisation.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <functional>

#include "dynamics/mass_matrix.hpp"
#include "dynamics/position_step.hpp"
#include "hopper/tracking/error_space.hpp"
#include "hopper/tracking/touch_down.hpp"
#include "tests/dynamics/rigid_impact.hpp"
#include "tests/hopper/tracking/closed_loop.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd allowed_by(const MatrixXd& rows) {
  Eigen::FullPivLU<MatrixXd> factors(rows);
  factors.setThreshold(1e-9);
  return factors.kernel();
}

TouchingPoints points(bool heel, bool toe) {
  TouchingPoints touches = TouchingPoints::Constant(4, heel);
  touches.tail(2).setConstant(toe);
  return touches;
}

class Linearisation : public testing::Test {
 protected:
  DrivenState at(double time_s) const {
    ReferenceInstant instant;
    planned.reference->at(time_s, instant);
    return {instant.position, instant.velocity, instant.drive_Nm};
  }
  /// Of each phase of the flip one instant, and what touches there.
  struct Case {
    DrivenState state;
    TouchingPoints touches;
  };
  std::vector<Case> cases() const {
    return {{at(0.5), points(true, true)},
            {at(0.6), points(true, false)},
            {at(0.7), points(false, false)},
            {at(1.2), points(true, true)}};
  }
  VectorXd moved(const VectorXd& position, const VectorXd& velocity, double time_s) const {
    VectorXd out(position.size());
    dynamics::step_position(planned.robot.tree, position, velocity, time_s, out);
    return out;
  }

  test::PlannedMotion planned{"hopper.json", "hopper_flip.csv"};
  WholeBody body{planned.robot};
  LinearDynamics dynamics{planned.robot};
};

// M a + h - A^T u lies in the rows of J: nothing of it is left along what the ground allows.
TEST_F(Linearisation, AccelerationsObeyNewtonAndTheGround) {
  for (const Case& one : cases()) {
    const auto acceleration = held_acceleration(body, one.state, one.touches);
    ASSERT_TRUE(acceleration);
    VectorXd force(9);
    body.inverse_dynamics(*acceleration, force);
    force -= drive_jacobian(body).transpose() * one.state.drive_Nm;
    const ContactRows rows = contact_rows(planned.robot, body.state(), one.touches);
    if (rows.jacobian.rows() == 0) {
      EXPECT_LT(force.norm(), 1e-10 * one.state.drive_Nm.norm());
      continue;
    }
    const MatrixXd allowed = allowed_by(rows.jacobian);
    EXPECT_LT((allowed.transpose() * force).norm(), 1e-10 * force.norm());
    // The points' velocities a moment later, central differences: h^2 of the third derivative.
    constexpr double kMoment_s = 1e-5;
    VectorXd apart = VectorXd::Zero(rows.jacobian.rows());
    for (const double side : {1.0, -1.0}) {
      const double t = side * kMoment_s;
      const VectorXd velocity = one.state.velocity + t * *acceleration;
      const VectorXd mean = 0.5 * (one.state.velocity + velocity);
      ASSERT_TRUE(body.set(moved(one.state.position, mean, t), velocity));
      apart += side * (contact_rows(planned.robot, body.state(), one.touches).jacobian * velocity);
    }
    EXPECT_LT(apart.norm() / (2.0 * kMoment_s), 1e-4 * (1.0 + acceleration->norm()));
  }
}

/// Differences over two steps, free of the error that goes with the square of the step.
MatrixXd wide_slopes(Index columns, const std::function<VectorXd(Index, double)>& value) {
  constexpr double kStep = 1e-3;
  MatrixXd slopes(9, columns);
  for (Index i = 0; i < columns; ++i) {
    const VectorXd near = (value(i, kStep) - value(i, -kStep)) / (2.0 * kStep);
    const VectorXd far = (value(i, 2.0 * kStep) - value(i, -2.0 * kStep)) / (4.0 * kStep);
    slopes.col(i) = (4.0 * near - far) / 3.0;
  }
  return slopes;
}

// The wide ones are off by h^4 = 1e-12 of fifth derivatives (some 1e3 of the slopes, at rates of 5
// to 10 in five more factors) and 1e-13 of rounding: shares of the greatest slope.
constexpr double kSlope = 1e-7;

TEST_F(Linearisation, SlopesOfAccelerationsAreThoseOfWiderDifferences) {
  for (const Case& one : cases()) {
    const auto slopes = acceleration_slopes(body, dynamics, one.state, one.touches);
    ASSERT_TRUE(slopes);
    const auto value = [&](const DrivenState& state) {
      return held_acceleration(body, state, one.touches).value();
    };
    const MatrixXd by_position = wide_slopes(9, [&](Index i, double step) {
      return value({moved(one.state.position, VectorXd::Unit(9, i), step), one.state.velocity,
                    one.state.drive_Nm});
    });
    const MatrixXd by_velocity = wide_slopes(9, [&](Index i, double step) {
      return value({one.state.position, one.state.velocity + step * VectorXd::Unit(9, i),
                    one.state.drive_Nm});
    });
    const MatrixXd by_drive = wide_slopes(3, [&](Index i, double step) {
      return value({one.state.position, one.state.velocity,
                    one.state.drive_Nm + step * VectorXd::Unit(3, i)});
    });
    EXPECT_LT((slopes->by_position - by_position).norm(), kSlope * by_position.norm());
    EXPECT_LT((slopes->by_velocity - by_velocity).norm(), kSlope * by_velocity.norm());
    EXPECT_LT((slopes->by_drive - by_drive).norm(), kSlope * by_drive.norm());
    EXPECT_LT((slopes->value - value(one.state)).norm(), 1e-12 * slopes->value.norm());
  }
}

TEST_F(Linearisation, ImpactIsTheOneOfRigidBodies) {
  const DrivenState before = at(std::nextafter(planned.reference->modes()[3].from_s, 0.0));
  for (const TouchingPoints& touches : {points(true, true), points(true, false)}) {
    const auto impact = impact_slopes(body, before, touches);
    ASSERT_TRUE(impact);
    // Its slopes by velocity are itself: it is linear in them. By position: wider differences.
    EXPECT_LT((impact->by_velocity * before.velocity - impact->value).norm(),
              1e-12 * impact->value.norm());
    const MatrixXd wide = wide_slopes(9, [&](Index i, double step) {
      return impact_slopes(
                 body,
                 {moved(before.position, VectorXd::Unit(9, i), step), before.velocity, VectorXd()},
                 touches)
          ->value;
    });
    EXPECT_LT((impact->by_position - wide).norm(), kSlope * wide.norm());
    ASSERT_TRUE(body.set(before.position, impact->value));
    const ContactRows rows = contact_rows(planned.robot, body.state(), touches);
    EXPECT_LT((rows.jacobian * impact->value).norm(), 1e-12 * before.velocity.norm());
    MatrixXd mass(9, 9);
    body.mass_matrix(mass);
    const VectorXd impulse = mass * (impact->value - before.velocity);
    const MatrixXd allowed = allowed_by(rows.jacobian);
    EXPECT_LT((allowed.transpose() * impulse).norm(), 1e-12 * impulse.norm());
  }
}

// Rabbit has its inertia in its bodies alone, so that the tests' own impact knows it.
TEST_F(Linearisation, ImpactOfRabbitIsTheTestsOwn) {
  const Robot rabbit = test::robot_of("rabbit.json");
  WholeBody walker(rabbit);
  const VectorXd position = (VectorXd(7) << 0, 0.7, 0.1, -0.3, 0.4, 0.2, 0.5).finished();
  const VectorXd velocity = (VectorXd(7) << 0.3, -1.0, 0.2, 0.1, -0.4, 0.3, 0.5).finished();
  TouchingPoints right = TouchingPoints::Constant(2, false);
  right[1] = true;
  const auto slopes = impact_slopes(walker, {position, velocity, VectorXd()}, right);
  ASSERT_TRUE(slopes);
  dynamics::TreeState state(rabbit.tree);
  state.set(position, velocity);
  const std::vector<torquewright::test::Contact> contacts = {
      {rabbit.contacts[1].point, Eigen::Vector3d::UnitZ(), 1e6, 0.0}};  // does not slip
  const auto expected = torquewright::test::impact(state, contacts);
  ASSERT_EQ(expected.status, torquewright::test::ImpactStatus::kSolved);
  EXPECT_LT((slopes->value - expected.velocity).norm(), 1e-9 * expected.velocity.norm());
}

// A state a little off before the impact falls on, at constant acceleration, until the landing
// points' mean height is the planned one; then comes the impact. Its difference from the planned
// one is the map: central differences, of second order as the slopes themselves.
TEST_F(Linearisation, TouchDownIsFallingToTheGroundAndTheImpact) {
  constexpr double kApart = 1e-5;
  const DrivenState before = at(std::nextafter(planned.reference->modes()[3].from_s, 0.0));
  const TouchingPoints none = points(false, false);
  for (const TouchingPoints& held : {points(true, true), points(true, false)}) {
    const auto down = touch_down(body, before, none, held);
    ASSERT_TRUE(down);
    ASSERT_EQ(down->unevenness.rows(), held.count());
    const VectorXd acceleration = held_acceleration(body, before, none).value();
    const auto heights_m = [&](const VectorXd& position) {
      EXPECT_TRUE(body.set(position, VectorXd::Zero(9)));
      VectorXd each_m(held.count());
      for (Index i = 0, row = 0; i < 4; ++i) {
        const auto& point = planned.robot.contacts[static_cast<std::size_t>(i)].point;
        if (held[i]) each_m[row++] = dynamics::point_position_m(body.state(), point).z();
      }
      return each_m;
    };
    const auto height_m = [&](const VectorXd& position) { return heights_m(position).mean(); };
    const auto uneven_m = [&](const VectorXd& position) -> VectorXd {
      return heights_m(position).array() - height_m(position);
    };
    const double ground_m = height_m(before.position);
    const auto landed = [&](const VectorXd& error, VectorXd& position) {
      const VectorXd from = moved(before.position, error.head(9), 1.0);
      const VectorXd speed = before.velocity + error.tail(9);
      const auto after = [&](double t) { return moved(from, speed + 0.5 * t * acceleration, t); };
      double early_s = -1e-2, late_s = 1e-2;
      for (int halving = 0; halving < 60; ++halving) {
        const double middle_s = 0.5 * (early_s + late_s);
        (height_m(after(middle_s)) > ground_m ? early_s : late_s) = middle_s;
      }
      position = after(early_s);
      const DrivenState state{position, speed + early_s * acceleration, before.drive_Nm};
      return impact_slopes(body, state, held)->value;
    };
    for (Index column = 0; column < 18; ++column) {
      VectorXd ahead, behind, apart(18);
      apart.tail(9) = landed(kApart * VectorXd::Unit(18, column), ahead);
      apart.tail(9) -= landed(-kApart * VectorXd::Unit(18, column), behind);
      dynamics::position_difference(planned.robot.tree, behind, ahead, apart.head(9));
      const auto close = [&](const VectorXd& difference, const MatrixXd& slopes) {
        const double off = (difference / (2.0 * kApart) - slopes.col(column)).norm();
        EXPECT_LT(off, 1e-5 * (1.0 + slopes.norm())) << column;
      };
      close(apart, down->after);
      close(uneven_m(ahead) - uneven_m(behind), down->unevenness);
    }
  }
}

// Two motions that begin a little apart, 40 steps of the engine on: their distance is what the
// model's steps make of it. In flight the engine is of fourth order, on the ground of second; the
// model holds its slopes over 0.5 ms; both are shares of the distance, below 1e-2 in 5 ms at rates
// of some 10/s.
TEST_F(Linearisation, ModelFollowsTheEngine) {
  constexpr double kPeriod_s = 5e-4, kApart = 1e-4;
  constexpr int kPeriods = 10, kSteps = 10;
  const auto run = [&](const VectorXd& position, const VectorXd& velocity, const VectorXd& drive_Nm,
                       VectorXd& end_position) -> VectorXd {
    const auto engine = own_engine(planned.robot, {});
    engine->start(position, velocity);
    for (int i = 0; i < kPeriods * kSteps; ++i) {
      EXPECT_TRUE(body.set(engine->position(), engine->velocity()));
      const VectorXd force = drive_jacobian(body).transpose() * drive_Nm;
      EXPECT_EQ(engine->step(force, kPeriod_s / kSteps), EngineOutcome::kStepped);
    }
    end_position = engine->position();
    return engine->velocity();
  };
  const VectorXd crouch = test::crouch(planned.robot);
  const Reference standing = test::standing(planned.robot, crouch, 1.0);
  ReferenceInstant still;
  standing.at(0.0, still);
  const Case on_ground{{still.position, still.velocity, still.drive_Nm}, points(true, true)};
  for (const Case& one : {on_ground, cases()[2]}) {
    VectorXd end_position, position = one.state.position;
    const VectorXd end_velocity =
        run(one.state.position, one.state.velocity, one.state.drive_Nm, end_position);
    VectorXd velocity = one.state.velocity;
    const auto start = error_space(body, position, velocity, one.touches);
    ASSERT_TRUE(start);
    for (Index column = 0; column < start->from_free.cols(); ++column) {
      VectorXd error = kApart * start->from_free.col(column);
      VectorXd moved_end;
      const VectorXd moved_velocity = run(moved(position, error.head(9), 1.0),
                                          velocity + error.tail(9), one.state.drive_Nm, moved_end);
      VectorXd apart(18);
      dynamics::position_difference(planned.robot.tree, end_position, moved_end, apart.head(9));
      apart.tail(9) = moved_velocity - end_velocity;
      // The model's slopes along the motion that was not moved.
      VectorXd q = one.state.position, v = one.state.velocity;
      for (int period = 0; period < kPeriods; ++period) {
        const DrivenState here{q, v, one.state.drive_Nm};
        const auto slopes = acceleration_slopes(body, dynamics, here, one.touches);
        ASSERT_TRUE(slopes);
        error = over(continuous_model(planned.robot.tree, *slopes, v), kPeriod_s).by_error * error;
        q = moved(q, v + 0.5 * kPeriod_s * slopes->value, kPeriod_s);
        v += kPeriod_s * slopes->value;
      }
      EXPECT_LT((apart - error).norm(), 2e-2 * error.norm()) << one.touches.any() << column;
    }
  }
}

// e^X by its series against the power of small steps: (1 + X/k)^k, k = 2^20, is off by X^2/2k.
TEST(DiscreteModel, IsTheExponential) {
  ContinuousModel model{(MatrixXd(3, 3) << 0, 30, 0, -20, 0, 1, 5, 0, -40).finished(),
                        (MatrixXd(3, 1) << 0, 2, 1).finished()};
  constexpr double kPeriod_s = 1e-3;
  const DiscreteModel discrete = over(model, kPeriod_s);
  MatrixXd whole = MatrixXd::Zero(4, 4);
  whole.topLeftCorner(3, 3) = model.by_error;
  whole.topRightCorner(3, 1) = model.by_drive;
  MatrixXd power = MatrixXd::Identity(4, 4) + kPeriod_s / (1 << 20) * whole;
  for (int i = 0; i < 20; ++i) power = (power * power).eval();
  EXPECT_LT((discrete.by_error - power.topLeftCorner(3, 3)).norm(), 1e-8);
  EXPECT_LT((discrete.by_drive - power.topRightCorner(3, 1)).norm(), 1e-8);
}

}  // namespace
}  // namespace torquewright::hopper
