// SPDX-License-Identifier: Apache-2.0
// Oracles: what free flight conserves, and a tuck with a closed form.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "dynamics/mass_matrix.hpp"
#include "dynamics/momentum.hpp"
#include "tests/dynamics/random_tree.hpp"

namespace torquewright::dynamics {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

struct Flight {
  Centroid whole;
  double energy_J = 0;
};

/// d(position)/dt; of the quaternion q half of q times (0, angular velocity in the base's axes).
VectorXd position_rate(const VectorXd& position, const VectorXd& v) {
  VectorXd rate(position.size());
  rate.head<3>() = v.head<3>();
  const double w = position[3];
  const Vector3d u = position.segment<3>(4);
  const Vector3d turn = v.segment<3>(3);
  rate[3] = -0.5 * u.dot(turn);
  rate.segment<3>(4) = 0.5 * (w * turn + u.cross(turn));
  rate.tail(v.size() - 6) = v.tail(v.size() - 6);
  return rate;
}

/// Half a second without forces at the joints, by fourth-order Runge-Kutta.
Flight fly(TreeState state, VectorXd q, VectorXd v, int steps) {
  const VectorXd none = VectorXd::Zero(v.size());
  const auto acceleration = [&](const VectorXd& at_q, const VectorXd& at_v) {
    VectorXd a(v.size());
    state.set(at_q, at_v);
    EXPECT_TRUE(forward_dynamics(state, none, a));
    return a;
  };
  const double h = 0.5 / steps;
  for (int step = 0; step < steps; ++step) {
    const VectorXd a1 = acceleration(q, v);
    const VectorXd r1 = position_rate(q, v);
    const VectorXd q2 = q + h / 2 * r1;
    const VectorXd v2 = v + h / 2 * a1;
    const VectorXd a2 = acceleration(q2, v2);
    const VectorXd r2 = position_rate(q2, v2);
    const VectorXd q3 = q + h / 2 * r2;
    const VectorXd v3 = v + h / 2 * a2;
    const VectorXd a3 = acceleration(q3, v3);
    const VectorXd r3 = position_rate(q3, v3);
    const VectorXd q4 = q + h * r3;
    const VectorXd v4 = v + h * a3;
    const VectorXd a4 = acceleration(q4, v4);
    q += h / 6 * (r1 + 2 * r2 + 2 * r3 + position_rate(q4, v4));
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  state.set(q, v);
  return {centroid(state), kinetic_energy_J(state) + potential_energy_J(state)};
}

TEST(FreeFlight, ConservesEnergyAndMomentum) {
  oracles::Dice dice(17);
  Tree tree = test::random_tree(dice, BaseKind::kSpatial, 4);
  for (Body& body : tree.bodies) {
    body.joint.kind = JointKind::kRevolute;  // a slide without a spring runs away
    body.joint.rotor_spin_kg_m2 = test::uniform_vector(dice, 3, 0.02);
  }
  TreeState state(tree);
  const VectorXd q = zero_position(tree);
  const VectorXd v = test::uniform_vector(dice, tree.velocity_size(), 2);
  state.set(q, v);
  const Centroid before = centroid(state);
  const double energy_J = kinetic_energy_J(state) + potential_energy_J(state);
  const Flight coarse = fly(state, q, v, 500);
  const Flight fine = fly(state, q, v, 1000);
  const auto turn_lost = [&](const Flight& flight) {
    return (flight.whole.angular_momentum_Nm_s - before.angular_momentum_Nm_s).norm();
  };
  EXPECT_LE(std::abs(fine.energy_J - energy_J), 1e-6);
  EXPECT_LE(std::abs(fine.energy_J - energy_J), std::abs(coarse.energy_J - energy_J) / 12 + 1e-11);
  EXPECT_LE(turn_lost(fine), 1e-6);
  EXPECT_LE(turn_lost(fine), turn_lost(coarse) / 12 + 1e-11);
  // The centre of mass flies a parabola.
  const Vector3d fall_m(0, 0, -0.5 * 9.81 * 0.25);
  const Vector3d expected_m = before.position_m + 0.5 * before.velocity_m_s + fall_m;
  EXPECT_LE((fine.whole.position_m - expected_m).norm(), 1e-7);
}

/// A bar with a bead that slides on either side of it, both at the distance of one joint each.
Tree bar_with_beads() {
  Tree tree;
  tree.base = BaseKind::kPlanar;
  const Eigen::Matrix3d bar = Eigen::Vector3d(0.5, 0.5, 0.01).asDiagonal();
  tree.bodies.push_back({.name = "bar", .parent = 0, .joint = {}, .inertia = {3, {0, 0, 0}, bar}});
  for (const double side : {1.0, -1.0}) {
    Joint slide;
    slide.kind = JointKind::kPrismatic;
    slide.axis = {0, 0, side};
    tree.bodies.push_back({.name = "bead",
                           .parent = 0,
                           .joint = slide,
                           .inertia = {2, {0, 0, 0}, Eigen::Matrix3d::Zero()}});
  }
  return tree;
}

// Oracle: pitch rate L/(J + 2 m s^2) while the beads stand at s(t) = s0 - u t; its integral is
// L/(u sqrt(2 m J)) (atan(k s0) - atan(k s)), k = sqrt(2 m/J). A somersault with a tuck: CAM stays,
// CAV grows.
TEST(FreeFlight, TucksAsTheClosedFormSays) {
  TreeState state(bar_with_beads());
  constexpr double kMomentum = 6.0;
  constexpr double kInertia = 0.5;
  constexpr double kTwoMasses = 4.0;
  const double k = std::sqrt(kTwoMasses / kInertia);
  for (int sample = 0; sample <= 200; ++sample) {
    const double t = 0.002 * sample;
    const double s = 0.5 - 0.75 * t;
    const double rate = kMomentum / (kInertia + kTwoMasses * s * s);
    const double pitch = kMomentum / (0.75 * std::sqrt(kTwoMasses * kInertia)) *
                         (std::atan(k * 0.5) - std::atan(k * s));
    VectorXd q(5);
    q << 0.3 * t, 2 * t - 0.5 * 9.81 * t * t, pitch, s, s;
    VectorXd v(5);
    v << 0.3, 2 - 9.81 * t, rate, -0.75, -0.75;
    state.set(q, v);
    const Centroid whole = centroid(state);
    EXPECT_NEAR(whole.angular_momentum_Nm_s.y(), kMomentum, 1e-12);
    EXPECT_NEAR(whole.angular_velocity_rad_s.y(), rate, 1e-12 * rate);
    // Nothing but the beads' slides is driven: d/dt of the rate is what forward dynamics finds.
    VectorXd force = VectorXd::Zero(5);
    force[3] = force[4] = -2 * s * rate * rate;  // holds the beads' speed against the spin
    VectorXd a(5);
    ASSERT_TRUE(forward_dynamics(state, force, a));
    EXPECT_NEAR(a[0], 0, 1e-11);
    EXPECT_NEAR(a[1], -9.81, 1e-11);
    EXPECT_NEAR(a[2], 2 * kTwoMasses * s * 0.75 * rate * rate / kMomentum, 1e-10);
    EXPECT_NEAR(a[3], 0, 1e-10);
  }
}

TEST(Centroid, TurnsAboutNoAxisWithoutInertia) {
  Tree tree;
  tree.base = BaseKind::kSpatial;
  const Eigen::Matrix3d needle = Eigen::Vector3d(0.2, 0.2, 0).asDiagonal();
  tree.bodies.push_back(
      {.name = "needle", .parent = 0, .joint = {}, .inertia = {1, {0, 0, 0}, needle}});
  TreeState state(tree);
  VectorXd v = VectorXd::Zero(6);
  v[3] = 5;
  v[5] = 7;
  state.set(zero_position(tree), v);
  EXPECT_LE((centroid(state).angular_velocity_rad_s - Vector3d(5, 0, 0)).norm(), 1e-12);
}

TEST(TreeState, RefusesWhatIsNoState) {
  Tree tree = bar_with_beads();
  tree.base = BaseKind::kSpatial;
  TreeState state(tree);
  VectorXd q = zero_position(tree);
  VectorXd v = VectorXd::Zero(8);
  EXPECT_THROW(state.set(v, v), std::invalid_argument);
  EXPECT_THROW(state.set(q, q), std::invalid_argument);
  q[3] = 0;
  EXPECT_THROW(state.set(q, v), std::invalid_argument);
  q[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(state.set(q, v), std::invalid_argument);
  q[3] = 2;  // not a unit quaternion, but one that says which
  v[0] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(state.set(q, v), std::invalid_argument);
  v[0] = 0;
  state.set(q, v);
  EXPECT_LE((state.motion(0).R_WB - Eigen::Matrix3d::Identity()).norm(), 1e-15);
}

TEST(Tree, RefusesWhatIsNoTree) {
  const Tree good = bar_with_beads();
  EXPECT_NO_THROW(require_tree(good));
  EXPECT_THROW(require_tree({}), std::invalid_argument);
  Tree bad = good;
  bad.bodies[1].parent = 1;
  EXPECT_THROW(require_tree(bad), std::invalid_argument);
  bad = good;
  bad.bodies[1].joint.axis *= 1.001;
  EXPECT_THROW(require_tree(bad), std::invalid_argument);
  bad = good;
  bad.bodies[1].joint.R_PB *= -1;
  EXPECT_THROW(require_tree(bad), std::invalid_argument);
  bad = good;
  bad.bodies[0].inertia.inertia_kg_m2(0, 1) = 0.1;
  EXPECT_THROW(require_tree(bad), std::invalid_argument);
  bad = good;
  bad.bodies[0].inertia.mass_kg = -1;
  EXPECT_THROW(require_tree(bad), std::invalid_argument);
  bad = good;
  bad.bodies[2].joint.reflected_inertia = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(require_tree(bad), std::invalid_argument);
}

}  // namespace
}  // namespace torquewright::dynamics
