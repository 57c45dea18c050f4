// SPDX-License-Identifier: Apache-2.0
// Oracles: the robot on its spatial base, as `hopper check` reckons with it; Lagrange's equation of
// a pendulum, by hand; conservation across impacts and the energy that Carnot's theorem says they
// take; and the general rigid impact of test::impact().
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <cmath>

#include "dynamics/momentum.hpp"
#include "dynamics/point.hpp"
#include "hopper/planning/model/laws.hpp"
#include "tests/dynamics/rigid_impact.hpp"
#include "tests/hopper/planning/sagittal_states.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::difference;
using test::moving_of;

constexpr double kSame = 1e-11;  // Hundreds of roundings, of the largest.

/// Rows of a planar tree on a spatial base: position, or rates.
VectorXd spatial_position(const VectorXd& planar) {
  VectorXd out = VectorXd::Zero(planar.size() + 4);
  out << planar[0], 0.0, planar[1], std::cos(0.5 * planar[2]), 0.0, std::sin(0.5 * planar[2]), 0.0,
      planar.tail(planar.size() - 3);
  return out;
}
VectorXd spatial_rates(const VectorXd& planar) {
  VectorXd out = VectorXd::Zero(planar.size() + 3);
  out << planar[0], 0.0, planar[1], 0.0, planar[2], 0.0, planar.tail(planar.size() - 3);
  return out;
}

class HopperInItsPlane : public testing::Test {
 protected:
  Robot robot = test::documented_robot("hopper");
  SagittalRobot plane = sagittal(robot);
  SagittalDynamicsOf<double> dynamics{plane};
  WholeBody whole{robot};
  oracles::Dice dice{3};
  Index m = plane.moving_count();
  Index size = robot.tree.velocity_size();

  void set(PlanFrame frame, const TreeMotion& rows) {
    dynamics.set(frame, moving_of(plane, rows.position), moving_of(plane, rows.velocity));
  }
};

TEST_F(HopperInItsPlane, NeedsWhatTheWholeBodyNeeds) {
  for (int sample = 0; sample < 30; ++sample) {
    const TreeMotion tree = test::random_motion(dice, plane);
    ASSERT_TRUE(whole.set(spatial_position(tree.position), spatial_rates(tree.velocity)));
    VectorXd force(size), given = VectorXd::Zero(size);
    whole.inverse_dynamics(spatial_rates(tree.acceleration), force);
    const VectorXd drive_Nm = test::uniform_vector(dice, 3, 100);
    whole.add_drive_torques(drive_Nm, given);
    std::vector<SoleForceOf<double>> forces;
    for (std::size_t i = 0; i < 2; ++i) {
      const double x = test::uniform(dice, -100, 100), z = test::uniform(dice, 0, 300);
      forces.push_back({i, x, z});
      for (const std::size_t member : plane.sole[i].members) {  // Left and right bear half each.
        dynamics::add_point_force(whole.state(), robot.contacts[member].point,
                                  Vector3d(0.5 * x, 0.0, 0.5 * z), given);
      }
    }
    const VectorXd needed = force - given;
    // Nothing leaves the plane: no force across it, no roll, no yaw.
    const double largest = needed.cwiseAbs().maxCoeff();
    EXPECT_LT(needed({1, 3, 5}).cwiseAbs().maxCoeff(), kSame * largest);
    for (const PlanFrame frame : {PlanFrame::kSole, PlanFrame::kMass}) {
      const TreeMotion rows = frame_motion(plane, frame, tree);
      set(frame, rows);
      const VectorXd ours =
          dynamics.residual(moving_of(plane, rows.acceleration), drive_Nm, forces);
      // Moving: x, z, pitch, knee, ankle pitch; held: ankle roll.
      EXPECT_LT(difference(ours, VectorXd(needed({0, 2, 4, 6, 7, 8}))), kSame);
    }
  }
}

TEST_F(HopperInItsPlane, TurnsItsDrivesAsTheWholeBodyDoes) {
  for (int sample = 0; sample < 30; ++sample) {
    const TreeMotion tree = test::random_motion(dice, plane);
    ASSERT_TRUE(whole.set(spatial_position(tree.position), spatial_rates(tree.velocity)));
    std::vector<DriveInstant> drives;
    whole.drives(spatial_rates(tree.acceleration), VectorXd::Zero(size), drives);
    const VectorXd drive_Nm = test::uniform_vector(dice, 3, 100);
    const VectorXd rate = moving_of(plane, tree.velocity).tail(2);
    const auto motion = drive_motion<double>(plane, moving_of(plane, tree.position).tail(2), rate,
                                             moving_of(plane, tree.acceleration).tail(2), drive_Nm);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto row = static_cast<Index>(i);
      EXPECT_NEAR(motion.speed_rad_s[row], drives[i].speed_rad_s, 1e-12);
      EXPECT_NEAR(motion.acceleration_rad_s2[row], drives[i].acceleration_rad_s2, 1e-10);
    }
    // No mechanism makes power: what drives give joints get, or the held joint, which is at rest.
    EXPECT_NEAR(motion.joint_Nm.dot(rate), drive_Nm.dot(motion.speed_rad_s), 1e-10);
  }
}

TEST_F(HopperInItsPlane, TurnsItsDrivesAtTheRateOfTheirPositions) {
  // Along q + w t + a t^2 / 2; fourth-order differences of the mechanisms' own positions. h^4/30 of
  // the fifth derivative, 1e5 at most, is 3e-9; of second differences h^4/90 of the sixth with
  // eps/h^2, 1e-10.
  constexpr double h = 1e-3;
  const TreeMotion tree = test::random_motion(dice, plane);
  const VectorXd q = moving_of(plane, tree.position).tail(2),
                 w = moving_of(plane, tree.velocity).tail(2),
                 a = moving_of(plane, tree.acceleration).tail(2);
  const auto positions = [&](double t) {
    VectorXd out(3);
    const VectorXd at = q + t * w + 0.5 * t * t * a;
    const SmallVector knee = at.head(1), ankle = Eigen::Vector2d(at[1], 0.0);
    const auto& drivetrains = robot.drivetrains;
    out << drivetrains[0].mechanism->transfer(knee, 0.0 * knee)->actuator_position_rad,
        drivetrains[1].mechanism->transfer(ankle, 0.0 * ankle)->actuator_position_rad;
    return out;
  };
  const VectorXd speed =
      (8.0 * (positions(h) - positions(-h)) - (positions(2 * h) - positions(-2 * h))) / (12.0 * h);
  const VectorXd rate = (16.0 * (positions(h) + positions(-h)) - 30.0 * positions(0.0) -
                         (positions(2 * h) + positions(-2 * h))) /
                        (12.0 * h * h);
  const auto motion = drive_motion<double>(plane, q, w, a, VectorXd::Zero(3));
  EXPECT_LT(difference(motion.speed_rad_s, speed), 1e-7);
  EXPECT_LT(difference(motion.acceleration_rad_s2, rate), 1e-6);
}

TEST(HopperWithShortRods, HasNoNumbersWhereTheyDoNotReach) {
  const SagittalRobot plane = test::hopper_with_short_rods();
  SagittalDynamicsOf<double> dynamics(plane);
  const VectorXd rest = VectorXd::Zero(5), none = VectorXd::Zero(3);
  VectorXd posture = VectorXd::Zero(5);
  posture.tail(2) << 1.0, -1.5;
  dynamics.set(PlanFrame::kSole, posture, rest);
  EXPECT_FALSE(dynamics.residual(rest, none, {}).allFinite());
  EXPECT_FALSE(dynamics.impact_residual(rest, {}).allFinite());
  const auto motion = drive_motion<double>(plane, Eigen::Vector2d(1.0, -1.5), Eigen::Vector2d(1, 1),
                                           Eigen::Vector2d(0, 0), none);
  EXPECT_TRUE(std::isfinite(motion.speed_rad_s[0]));  // The knee's is another mechanism.
  EXPECT_FALSE(std::isfinite(motion.speed_rad_s[1]));
  EXPECT_FALSE(std::isfinite(motion.acceleration_rad_s2[2]));
  posture[4] = 0.0;  // And there it has them again.
  dynamics.set(PlanFrame::kSole, posture, rest);
  EXPECT_TRUE(dynamics.residual(rest, none, {}).allFinite());
}

TEST_F(HopperInItsPlane, IsTheSameInstantInEitherFrame) {
  for (int sample = 0; sample < 20; ++sample) {
    const TreeMotion tree = test::random_motion(dice, plane);
    const TreeMotion sole = frame_motion(plane, PlanFrame::kSole, tree);
    const TreeMotion mass = frame_motion(plane, PlanFrame::kMass, tree);
    set(PlanFrame::kSole, sole);
    EXPECT_LT(difference(dynamics.position_in(PlanFrame::kMass), moving_of(plane, mass.position)),
              1e-13);
    EXPECT_LT(difference(dynamics.velocity_in(PlanFrame::kMass), moving_of(plane, mass.velocity)),
              1e-13);
    EXPECT_LT(difference(dynamics.position_in(PlanFrame::kSole), moving_of(plane, sole.position)),
              1e-13);
    set(PlanFrame::kMass, mass);
    EXPECT_LT(difference(dynamics.position_in(PlanFrame::kSole), moving_of(plane, sole.position)),
              1e-13);
    EXPECT_LT(difference(dynamics.velocity_in(PlanFrame::kSole), moving_of(plane, sole.velocity)),
              1e-13);
  }
}

/// Velocity after and impulses, by the laws as a solver has them: both are linear.
struct Landing {
  VectorXd before, after;  ///< (m) of the sole's frame.
  VectorXd impulses;       ///< (f)
};

Landing land(const SagittalRobot& plane, const Stance& stance, const VectorXd& position,
             const VectorXd& before) {
  const auto scratch = std::make_shared<SagittalScratch>(plane);
  const Index m = plane.moving_count(), f = static_cast<Index>(stance.force_count());
  const auto rows = [&](const VectorXd& unknown) {
    VectorXd impact(3 * m - 2 + f), rest(2 * m - 2), out(m + f), impact_rows(m), rest_rows(f);
    impact << position.tail(m - 2), before, unknown;
    rest << position.tail(m - 2), unknown.head(m);
    ImpactLaw{scratch, stance}(impact, impact_rows);
    ContactVelocityLaw{scratch, stance}(rest, rest_rows);
    out << impact_rows, rest_rows;
    return out;
  };
  const VectorXd constant = rows(VectorXd::Zero(m + f));
  MatrixXd columns(m + f, m + f);
  for (Index i = 0; i < m + f; ++i) columns.col(i) = rows(VectorXd::Unit(m + f, i)) - constant;
  const VectorXd solution = columns.partialPivLu().solve(-constant);
  return {before, solution.head(m), solution.tail(f)};
}

struct Touch {
  const char* name;
  Stance stance;
};

std::ostream& operator<<(std::ostream& out, const Touch& one) { return out << one.name; }

class HopperLands : public HopperInItsPlane, public testing::WithParamInterface<Touch> {
 protected:
  Stance stance = GetParam().stance;

  /// A posture whose sole is level where it lands flat.
  TreeMotion before() {
    TreeMotion tree = test::random_motion(dice, plane);
    if (stance.is_flat()) tree.position[2] = -tree.position[3] - tree.position[4];
    return frame_motion(plane, PlanFrame::kSole, tree);
  }
  /// The tree's velocity (spatial) of one of the sole's frame.
  VectorXd tree_velocity(const TreeMotion& rows, const VectorXd& moving) {
    TreeMotion changed = rows;
    changed.velocity = plane.all_rows(moving);
    return spatial_rates(tree_motion(plane, PlanFrame::kSole, changed).velocity);
  }
  VectorXd tree_position(const TreeMotion& rows) {
    return spatial_position(tree_motion(plane, PlanFrame::kSole, rows).position);
  }
  Vector3d impulse(const Landing& landing) const {
    return {landing.impulses[0], 0.0, landing.impulses.tail(landing.impulses.size() - 1).sum()};
  }
};

TEST_P(HopperLands, WithMomentumAndWithoutNewEnergy) {
  for (int sample = 0; sample < 20; ++sample) {
    const TreeMotion rows = before();
    const Landing landing =
        land(plane, stance, moving_of(plane, rows.position), moving_of(plane, rows.velocity));
    const VectorXd position = tree_position(rows);
    const VectorXd v0 = tree_velocity(rows, landing.before),
                   v1 = tree_velocity(rows, landing.after);
    dynamics::TreeState state(robot.tree);
    state.set(position, v0);
    const dynamics::Centroid first = dynamics::centroid(state);
    state.set(position, v1);
    const dynamics::Centroid then = dynamics::centroid(state);
    const Vector3d change_N_s = first.mass_kg * (then.velocity_m_s - first.velocity_m_s);
    EXPECT_LT((change_N_s - impulse(landing)).norm(), 1e-10 * change_N_s.norm());
    // The moment of the impulses about the centre of mass, point by point.
    Vector3d moment_Nm_s = Vector3d::Zero();
    for (std::size_t i = 0; i < stance.points.size(); ++i) {
      const dynamics::BodyPoint& point = plane.sole[stance.points[i]].point;
      const Vector3d given(i == 0 ? landing.impulses[0] : 0.0, 0.0,
                           landing.impulses[1 + static_cast<Index>(i)]);
      moment_Nm_s += (dynamics::point_position_m(state, point) - then.position_m).cross(given);
      EXPECT_LT(dynamics::point_velocity_m_s(state, point).norm(), 1e-12);  // Touched, and at rest.
    }
    EXPECT_NEAR(then.angular_momentum_Nm_s.y() - first.angular_momentum_Nm_s.y(), moment_Nm_s.y(),
                1e-11);
    // Carnot: what is lost is the kinetic energy of the velocity that is lost.
    ASSERT_TRUE(whole.set(position, v0));
    MatrixXd mass(size, size);
    whole.mass_matrix(mass);
    const VectorXd lost = v0 - v1;
    const double lost_J = 0.5 * v0.dot(mass * v0) - 0.5 * v1.dot(mass * v1);
    EXPECT_GT(lost_J, 0.0);
    EXPECT_NEAR(lost_J, 0.5 * lost.dot(mass * lost), 1e-11 * (1.0 + v0.dot(mass * v0)));
  }
}

/// All contact points held in space and ankle roll held as the plan has it: least squares of as
/// many rows as there are.
TEST_P(HopperLands, AsInSpace) {
  for (int sample = 0; sample < 10; ++sample) {
    const TreeMotion rows = before();
    const Landing landing =
        land(plane, stance, moving_of(plane, rows.position), moving_of(plane, rows.velocity));
    const VectorXd v0 = tree_velocity(rows, landing.before);
    ASSERT_TRUE(whole.set(tree_position(rows), v0));
    MatrixXd mass(size, size), held(0, size);
    whole.mass_matrix(mass);
    Eigen::Matrix<double, 3, Eigen::Dynamic> jacobian(3, size);
    for (const std::size_t touched : stance.points) {
      for (const std::size_t member : plane.sole[touched].members) {
        dynamics::point_jacobian(whole.state(), robot.contacts[member].point, jacobian);
        held.conservativeResize(held.rows() + 3, Eigen::NoChange);
        held.bottomRows<3>() = jacobian;
      }
    }
    held.conservativeResize(held.rows() + 1, Eigen::NoChange);
    held.bottomRows<1>() = VectorXd::Unit(size, size - 1).transpose();
    const MatrixXd answer = mass.llt().solve(held.transpose());
    const MatrixXd mobility = held * answer;
    const VectorXd v1 = v0 - answer * mobility.completeOrthogonalDecomposition().solve(held * v0);
    EXPECT_LT(difference(tree_velocity(rows, landing.after), v1), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(, HopperLands,
                         testing::Values(Touch{"OnItsHeel", {"heel", {0}}},
                                         Touch{"OnItsToe", {"toe", {1}}},
                                         Touch{"Flat", {"flat", {0, 1}}}),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(LegLands, AsTheGeneralRigidImpactSays) {
  const SagittalRobot plane = sagittal(test::documented_robot("planar_leg"));
  const Stance stance{"flat", {0}};
  oracles::Dice dice(8);
  dynamics::TreeState state(plane.robot.tree);  // Its rotors stand in the joints.
  int compared = 0;
  for (int sample = 0; sample < 40; ++sample) {
    TreeMotion tree = test::random_motion(dice, plane);
    tree.velocity[1] -= 3.0;
    const TreeMotion rows = frame_motion(plane, PlanFrame::kSole, tree);
    const Landing landing =
        land(plane, stance, moving_of(plane, rows.position), moving_of(plane, rows.velocity));
    state.set(tree.position, tree.velocity);
    const double friction = 1e3;  // It sticks, wherever the ground only pushes.
    const test::Contact contact{plane.sole[0].point, Vector3d::UnitZ(), friction, 0.0};
    const test::Impact impact = test::impact(state, {&contact, 1});
    ASSERT_EQ(impact.status, test::ImpactStatus::kSolved);
    if (landing.impulses[1] < 1e-2 * std::abs(landing.impulses[0])) continue;
    ++compared;
    EXPECT_NEAR(landing.impulses[0], impact.impulses_N_s[0].x(), 1e-8);
    EXPECT_NEAR(landing.impulses[1], impact.impulses_N_s[0].z(), 1e-8);
    TreeMotion after = rows;
    after.velocity = plane.all_rows(landing.after);
    EXPECT_LT(difference(tree_motion(plane, PlanFrame::kSole, after).velocity, impact.velocity),
              1e-8);
  }
  EXPECT_GT(compared, 10);
}

/// About the pin: K theta'' = m g l sin(theta) - T of the base, I phi'' = T of the foot, whose
/// pitch phi is the base's theta and the joint's; T = u - J (phi - theta)'' of a drive and its
/// rotor J.
TEST(PendulumOnAPoint, ObeysLagrange) {
  const test::Pendulum is;
  const SagittalRobot plane = sagittal(test::pendulum(is, 0.0, 0.0));
  ASSERT_EQ(plane.moving_count(), 4);
  SagittalDynamicsOf<double> dynamics(plane);
  const double g = plane.robot.tree.gravity_m_s2, K = is.base_kg_m2, I = is.foot_kg_m2,
               J = is.rotor_kg_m2, l = is.height_m;
  oracles::Dice dice(2);
  for (int sample = 0; sample < 10; ++sample) {
    const double theta = test::uniform(dice, -3, 3), phi = test::uniform(dice, -3, 3),
                 theta_s = test::uniform(dice, -3, 3), phi_s = test::uniform(dice, -3, 3),
                 u = test::uniform(dice, -50, 50);
    const double fall_Nm = is.mass_kg * g * l * std::sin(theta);
    // phi'' - theta'' = T (1/I + 1/K) - fall/K.
    const double T = (u + J * fall_Nm / K) / (1.0 + J / I + J / K);
    const double theta_s2 = (fall_Nm - T) / K, phi_s2 = T / I;
    const double x_N =
        is.mass_kg * l * (std::cos(theta) * theta_s2 - std::sin(theta) * theta_s * theta_s);
    const double z_N =
        (is.mass_kg + is.foot_kg) * g -
        is.mass_kg * l * (std::sin(theta) * theta_s2 + std::cos(theta) * theta_s * theta_s);
    dynamics.set(PlanFrame::kSole, Eigen::Vector4d(0, 0, phi, phi - theta),
                 Eigen::Vector4d(0, 0, phi_s, phi_s - theta_s));
    const VectorXd rows = dynamics.residual(Eigen::Vector4d(0, 0, phi_s2, phi_s2 - theta_s2),
                                            VectorXd::Constant(1, u), {{0, x_N, z_N}});
    EXPECT_LT(rows.cwiseAbs().maxCoeff(), 1e-10);
  }
}

}  // namespace
}  // namespace torquewright::hopper
