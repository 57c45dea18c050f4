// SPDX-License-Identifier: Apache-2.0
#include "tests/dynamics/rigid_impact.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "dynamics/mass_matrix.hpp"
#include "dynamics/momentum.hpp"
#include "tests/dynamics/random_tree.hpp"

namespace torquewright::dynamics {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::Contact;
using test::difference;
using test::impact;
using test::ImpactStatus;

constexpr double kRoundOff = 1e-11;

/// A uniform rod of 2 kg and 1 m in the plane, its lower end at the origin of its frame.
struct Rod {
  static constexpr double kMass = 2;
  static constexpr double kHalf = 0.5;
  static constexpr double kInertia = kMass / 12;
  explicit Rod(double pitch, const VectorXd& velocity) : state(tree()) {
    VectorXd q(3);
    q << 1, 0, pitch;
    state.set(q, velocity);
    // Of the centre seen from the end that strikes.
    x_m = kHalf * std::sin(pitch);
    z_m = kHalf * std::cos(pitch);
  }
  static Tree tree() {
    Tree rod;
    rod.base = BaseKind::kPlanar;
    rod.bodies.push_back(
        {.name = "rod",
         .parent = 0,
         .joint = {},
         .inertia = {kMass, {0, 0, kHalf}, kInertia * Eigen::Matrix3d::Identity()}});
    return rod;
  }
  TreeState state;
  double x_m = 0;
  double z_m = 0;
};

VectorXd vector_of(double a, double b, double c) { return Vector3d(a, b, c); }

// Oracle: the rod that falls on one end without friction:
// p = (1 + e) v m I/(I + m x^2), x the centre's horizontal distance from the end.
TEST(Impact, OfAFallingRodOnSmoothGroundIsTheClosedForm) {
  for (const double pitch : {-1.2, -0.4, 0.0, 0.3, 0.9, 1.4}) {
    for (const double restitution : {0.0, 0.3, 1.0}) {
      Rod rod(pitch, vector_of(0.7, -3, 0));
      const std::vector<Contact> end{{.restitution = restitution}};
      const test::Impact hit = impact(rod.state, end);
      ASSERT_EQ(hit.status, ImpactStatus::kSolved);
      const double share = Rod::kInertia / (Rod::kInertia + Rod::kMass * rod.x_m * rod.x_m);
      const double impulse = (1 + restitution) * 3 * Rod::kMass * share;
      EXPECT_LE((hit.impulses_N_s[0] - Vector3d(0, 0, impulse)).norm(), kRoundOff);
      EXPECT_NEAR(hit.velocity[1], 3 * restitution, kRoundOff);
      // The impulse passes in front of or behind the centre: r x p about +y is x p_z... of (-x,
      // -z).
      EXPECT_NEAR(hit.velocity[2], rod.x_m * impulse / Rod::kInertia, kRoundOff);
    }
  }
}

// Oracle: the end stops dead and the rod turns about it; angular momentum about the end stays.
TEST(Impact, OfAFallingRodOnRoughGroundStopsItsEnd) {
  Rod rod(0.5, vector_of(0.4, -3, -0.8));
  const std::vector<Contact> end{{.friction_coefficient = 50}};
  const test::Impact hit = impact(rod.state, end);
  ASSERT_EQ(hit.status, ImpactStatus::kSolved);
  EXPECT_LE(hit.velocity.head<2>().norm(), kRoundOff);
  // Before: own spin plus r x m v_c, positive about +y.
  const double vx = 0.4 - 0.8 * rod.z_m;
  const double vz = -3 + 0.8 * rod.x_m;
  const double about_end = Rod::kInertia * -0.8 + Rod::kMass * (rod.z_m * vx - rod.x_m * vz);
  EXPECT_NEAR(hit.velocity[2], about_end / (Rod::kInertia + Rod::kMass * 0.25), kRoundOff);
}

// Oracle: with the slide's direction known, p_x = -mu p_z sign(slip), and the normal equation
// (1/m + x^2/I) p_z - (x z/I) p_x = v gives p_z.
TEST(Impact, OfASlidingRodIsTheClosedForm) {
  for (const double slip : {5.0, -5.0}) {
    Rod rod(0.4, vector_of(slip, -2, 0));
    const std::vector<Contact> end{{.friction_coefficient = 0.2}};
    const test::Impact hit = impact(rod.state, end);
    ASSERT_EQ(hit.status, ImpactStatus::kSolved);
    const double sign = slip > 0 ? 1 : -1;
    const double along = 1 / Rod::kMass + rod.x_m * rod.x_m / Rod::kInertia;
    const double across = rod.x_m * rod.z_m / Rod::kInertia;
    const double p_z = 2 / (along + 0.2 * sign * across);
    EXPECT_NEAR(hit.impulses_N_s[0].z(), p_z, kRoundOff);
    EXPECT_NEAR(hit.impulses_N_s[0].x(), -0.2 * sign * p_z, kRoundOff);
    EXPECT_GT(sign * hit.velocity[0], 0) << "it slides on";
  }
}

struct Crash {
  Crash(std::uint64_t seed, std::size_t points, double restitution) : dice(seed), state(drawn()) {
    const VectorXd q = test::random_position(dice, state.tree());
    state.set(q, test::uniform_vector(dice, state.velocity().size(), 3));
    for (std::size_t i = 0; i < points; ++i) {
      contacts.push_back(
          {.point = {static_cast<std::size_t>(dice.between(0, 5)),
                     test::uniform_vector(dice, 3, 0.3)},
           .normal = (Vector3d::UnitZ() + 0.8 * test::random_direction(dice)).normalized(),
           .friction_coefficient = test::uniform(dice, 0, 1),
           .restitution = restitution});
    }
  }
  Tree drawn() { return test::random_tree(dice, BaseKind::kSpatial, 5); }
  oracles::Dice dice;
  TreeState state;
  std::vector<Contact> contacts;
};

void expect_the_law(TreeState& state, const Contact& contact, const VectorXd& after,
                    const Vector3d& impulse) {
  Eigen::Matrix<double, 3, Eigen::Dynamic> jacobian(3, state.velocity().size());
  point_jacobian(state, contact.point, jacobian);
  const double tolerance = 1e-9 * (1 + impulse.norm());
  const double approach = contact.normal.dot(jacobian * state.velocity());
  const Vector3d velocity = jacobian * after;
  const double normal_impulse = contact.normal.dot(impulse);
  const double rest = contact.normal.dot(velocity) + contact.restitution * std::min(0.0, approach);
  EXPECT_GE(normal_impulse, 0);
  EXPECT_GE(rest, -tolerance);
  EXPECT_NEAR(normal_impulse * rest, 0, tolerance * (1 + normal_impulse));
  const Vector3d along = impulse - normal_impulse * contact.normal;
  const Vector3d slip = velocity - contact.normal.dot(velocity) * contact.normal;
  const double limit = contact.friction_coefficient * normal_impulse;
  EXPECT_LE(along.norm(), limit + tolerance);
  if (slip.norm() > 1e-6 && normal_impulse > 0) {
    EXPECT_LE((along + limit * slip.normalized()).norm(), 1e-6 * (1 + limit));
  }
}

// Oracle: the law itself, and Newton's: momentum about the centre changes by the impulses.
TEST(Impact, KeepsTheLawOfEveryContactAndAllMomentum) {
  int slides = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Crash crash(seed, 1 + seed % 3, seed % 2 == 0 ? 0.0 : 0.4);
    const VectorXd before_v = crash.state.velocity();
    const test::Impact hit = impact(crash.state, crash.contacts);
    ASSERT_EQ(hit.status, ImpactStatus::kSolved) << seed;
    for (std::size_t i = 0; i < crash.contacts.size(); ++i) {
      expect_the_law(crash.state, crash.contacts[i], hit.velocity, hit.impulses_N_s[i]);
      if (hit.impulses_N_s[i].norm() > 0) ++slides;
    }
    MatrixXd momentum(6, before_v.size());
    centroidal_momentum_matrix(crash.state, momentum);
    const VectorXd change = momentum * (hit.velocity - before_v);
    const Vector3d center = centroid(crash.state).position_m;
    VectorXd given = VectorXd::Zero(6);
    for (std::size_t i = 0; i < crash.contacts.size(); ++i) {
      const Vector3d arm = point_position_m(crash.state, crash.contacts[i].point) - center;
      given.head<3>() += arm.cross(hit.impulses_N_s[i]);
      given.tail<3>() += hit.impulses_N_s[i];
    }
    EXPECT_LE(difference(change, given), 1e-10);
    MatrixXd mass(before_v.size(), before_v.size());
    mass_matrix(crash.state, mass);
    const double lost_J =
        0.5 * before_v.dot(mass * before_v) - 0.5 * hit.velocity.dot(mass * hit.velocity);
    EXPECT_NEAR(hit.lost_energy_J, lost_J, 1e-9 * std::max(1.0, before_v.dot(mass * before_v)));
    if (seed % 2 == 0) {
      EXPECT_GE(hit.lost_energy_J, -1e-10);
    }
  }
  EXPECT_GT(slides, 100) << "contacts that are hit at all";
}

// Oracle: the reset map of stance, v+ = v- - M^-1 J^T (J M^-1 J^T)^-1 J v-, by plain inverses.
TEST(Impact, ThatSticksIsTheResetMap) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Crash crash(seed, 1, 0);
    crash.contacts[0].friction_coefficient = 1e3;
    Eigen::Matrix<double, 3, Eigen::Dynamic> J(3, crash.state.velocity().size());
    point_jacobian(crash.state, crash.contacts[0].point, J);
    const VectorXd v = crash.state.velocity();
    MatrixXd mass(v.size(), v.size());
    mass_matrix(crash.state, mass);
    const MatrixXd B = mass.inverse() * J.transpose();
    const Vector3d impulse = -((J * B).inverse() * (J * v));
    if (impulse.dot(crash.contacts[0].normal) < 0.02 * impulse.norm())
      continue;  // leaves or slides
    if (crash.contacts[0].normal.dot(J * v) > 0) continue;
    const test::Impact hit = impact(crash.state, crash.contacts);
    EXPECT_LE(difference(hit.velocity, VectorXd(v + B * impulse)), 1e-9);
    ++compared;
  }
  EXPECT_GT(compared, 15);
}

// Oracle: a box that falls flat on four corners stops; how they share it is anyone's.
TEST(Impact, OfFourCornersStopsABoxFlat) {
  Tree box;
  box.base = BaseKind::kSpatial;
  const Eigen::Matrix3d inertia = Vector3d(0.1, 0.12, 0.15).asDiagonal();
  box.bodies.push_back(
      {.name = "box", .parent = 0, .joint = {}, .inertia = {3, {0, 0, 0}, inertia}});
  TreeState state(box);
  VectorXd v = VectorXd::Zero(6);
  v[2] = -2;
  state.set(zero_position(box), v);
  std::vector<Contact> corners;
  for (const double x : {-0.2, 0.2}) {
    for (const double y : {-0.1, 0.1}) {
      corners.push_back({.point = {0, {x, y, -0.1}}, .friction_coefficient = 0.5});
    }
  }
  const test::Impact hit = impact(state, corners);
  ASSERT_EQ(hit.status, ImpactStatus::kSolved);
  EXPECT_LE(hit.velocity.norm(), 1e-9);
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& impulse : hit.impulses_N_s) sum += impulse;
  EXPECT_LE((sum - Vector3d(0, 0, 6)).norm(), 1e-9);
}

TEST(Impact, LeavesAPartingContactAlone) {
  Rod rod(0.2, vector_of(0, 1, 0));
  const std::vector<Contact> end{{.friction_coefficient = 1, .restitution = 1}};
  const test::Impact hit = impact(rod.state, end);
  EXPECT_EQ(hit.status, ImpactStatus::kSolved);
  EXPECT_EQ(hit.velocity, rod.state.velocity());
  EXPECT_EQ(impact(rod.state, {}).velocity, rod.state.velocity());
}

TEST(Impact, RefusesWhatIsNoContact) {
  Rod rod(0.2, vector_of(0, 1, 0));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Contact> bad{{.point = {.body = 1}},         {.normal = {0, 0, 1.1}},
                                 {.friction_coefficient = -0.1}, {.friction_coefficient = nan},
                                 {.restitution = 1.01},          {.restitution = nan}};
  for (const Contact& contact : bad) {
    EXPECT_THROW((void)impact(rod.state, std::vector<Contact>{contact}), std::invalid_argument);
  }
}

TEST(Impact, SaysWhereInertiaIsMissing) {
  Tree nothing;
  nothing.base = BaseKind::kPlanar;
  nothing.bodies.emplace_back();
  TreeState state(nothing);
  const std::vector<Contact> one(1);
  EXPECT_EQ(impact(state, one).status, ImpactStatus::kNoInertia);
}

}  // namespace
}  // namespace torquewright::dynamics
