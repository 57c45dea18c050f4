// SPDX-License-Identifier: Apache-2.0
// Oracles: closed forms of a ball, a block, a rocking block and a rod; conservation of energy and
// momentum.
#include "simulation/contact/time_stepping.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "dynamics/momentum.hpp"

namespace torquewright::simulation {
namespace {

using dynamics::BaseKind;
using dynamics::kGravity_m_s2;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kMass_kg = 2.0;

dynamics::Tree one_body(BaseKind base, const Vector3d& inertia_kg_m2) {
  dynamics::Tree tree;
  tree.base = base;
  tree.bodies.push_back({.name = "body", .joint = {}, .inertia = {}});
  tree.bodies.front().inertia.mass_kg = kMass_kg;
  tree.bodies.front().inertia.inertia_kg_m2 = inertia_kg_m2.asDiagonal();
  return tree;
}

GroundPoint at(const Vector3d& place_m, double friction, double restitution = 0.0) {
  return {{0, place_m}, friction, restitution};
}

/// A body under way.
struct Bench {
  Bench(const dynamics::Tree& tree, std::vector<GroundPoint> points, double time_constant_s = 0.0)
      : bodies(tree),
        stepping(bodies, {.points = std::move(points), .time_constant_s = time_constant_s}),
        position(dynamics::zero_position(tree)),
        velocity(VectorXd::Zero(tree.velocity_size())),
        force(velocity) {}

  void step(double step_s) {
    if (stepping.step(position, velocity, force, step_s) == TimeStepping::Outcome::kStepped) return;
    throw std::runtime_error("the step failed");
  }
  double energy_J() {
    EXPECT_TRUE(bodies.set(position, velocity));
    return dynamics::kinetic_energy_J(bodies.state()) +
           dynamics::potential_energy_J(bodies.state());
  }

  BareTree bodies;
  TimeStepping stepping;
  VectorXd position, velocity, force;
};

// What falls at v on a critically damped spring of time constant T sinks by z(t) = g T^2 +
// (a + b t) exp(-t/T), a = -g T^2, b = v + a/T, and comes to rest g T^2 deep.
TEST(TimeStepping, SoftGroundGivesAsItsSpringDoes) {
  constexpr double kConstant_s = 0.01, kStep_s = 1e-5, kSpeed_m_s = 1.0;
  const dynamics::Tree tree = one_body(BaseKind::kSpatial, {0.1, 0.1, 0.1});
  Bench bench(tree, {at({0.0, 0.0, 0.0}, 0.5, 0.9)}, kConstant_s);
  bench.velocity[2] = -kSpeed_m_s;
  const double rests_m = kGravity_m_s2 * kConstant_s * kConstant_s;
  const double a = -rests_m, b = kSpeed_m_s + a / kConstant_s;
  for (int i = 1; i <= 20000; ++i) {
    bench.step(kStep_s);
    const double t = i * kStep_s;
    const double sunk_m = rests_m + (a + b * t) * std::exp(-t / kConstant_s);
    ASSERT_NEAR(-bench.position[2], sunk_m, 3e-3 * kSpeed_m_s * kConstant_s) << t;
  }
  EXPECT_NEAR(-bench.position[2], rests_m, 1e-3 * rests_m);
}

// Falls from h, bounces to e^2 h: impacts at t_0 = sqrt(2 h/g) and 2 e t_0 later.
TEST(Ball, BouncesAsItsRestitutionSays) {
  constexpr double kHeight_m = 0.5, kRadius_m = 0.1, kRestitution = 0.6, kStep_s = 1e-4;
  Bench ball(one_body(BaseKind::kPlanar, {0.01, 0.01, 0.01}),
             {at({0, 0, -kRadius_m}, 0.5, kRestitution)});
  ball.position[1] = kRadius_m + kHeight_m;
  std::vector<double> impacts_s;
  double highest_m = 0.0;
  for (int i = 0; i < 9000 && impacts_s.size() < 2; ++i) {
    ball.step(kStep_s);
    if (ball.stepping.impulses_N_s().norm() > 0.0) impacts_s.push_back(kStep_s * i);
    if (impacts_s.size() == 1) highest_m = std::max(highest_m, ball.position[1] - kRadius_m);
  }
  const double first_s = std::sqrt(2.0 * kHeight_m / kGravity_m_s2);
  ASSERT_EQ(impacts_s.size(), 2u);
  EXPECT_NEAR(impacts_s[0], first_s, 2.0 * kStep_s);
  EXPECT_NEAR(impacts_s[1], first_s * (1.0 + 2.0 * kRestitution), 5.0 * kStep_s);
  const double impact_m_s = std::sqrt(2.0 * kGravity_m_s2 * kHeight_m);
  EXPECT_NEAR(highest_m, kRestitution * kRestitution * kHeight_m, 2.0 * impact_m_s * kStep_s);
}

constexpr double kHalfLength_m = 0.2, kHalfHeight_m = 0.1;

std::vector<GroundPoint> two_feet(double friction) {
  return {at({-kHalfLength_m, 0, -kHalfHeight_m}, friction),
          at({kHalfLength_m, 0, -kHalfHeight_m}, friction)};
}

// a = -mu g; the feet carry m g/2 (1 -+ mu h/l), h above the ground, feet at -+l.
TEST(Block, SlidesToAStop) {
  constexpr double kFriction = 0.4, kSpeed_m_s = 2.0, kStep_s = 1e-3;
  Bench block(one_body(BaseKind::kPlanar, {0.02, 0.03, 0.02}), two_feet(kFriction));
  block.position[1] = kHalfHeight_m - 1e-10;  // touches, rounding or not
  block.velocity[0] = kSpeed_m_s;
  block.step(kStep_s);
  const double weight_N_s = kMass_kg * kGravity_m_s2 * kStep_s;
  const double tilt = kFriction * kHalfHeight_m / kHalfLength_m;
  for (int i = 0; i < 10; ++i) block.step(kStep_s);
  const VectorXd& impulses = block.stepping.impulses_N_s();
  EXPECT_NEAR(impulses[2], 0.5 * weight_N_s * (1.0 - tilt), 1e-9);
  EXPECT_NEAR(impulses[5], 0.5 * weight_N_s * (1.0 + tilt), 1e-9);
  EXPECT_NEAR(impulses[0], -kFriction * impulses[2], 1e-12);
  for (int i = 0; i < 1000; ++i) block.step(kStep_s);
  EXPECT_NEAR(block.position[0], kSpeed_m_s * kSpeed_m_s / (2.0 * kFriction * kGravity_m_s2),
              kSpeed_m_s * kStep_s);
  EXPECT_NEAR(block.velocity.norm(), 0.0, 1e-12);
}

// Below mu m g it holds to the last digit, above it accelerates by F/m - mu g.
TEST(Block, HoldsUntilFrictionIsUsedUp) {
  constexpr double kFriction = 0.5, kStep_s = 1e-3;
  const double most_N = kFriction * kMass_kg * kGravity_m_s2;
  for (const double share : {0.99, 1.5}) {
    Bench block(one_body(BaseKind::kPlanar, {0.02, 0.03, 0.02}), two_feet(kFriction));
    block.position[1] = kHalfHeight_m;
    block.force[0] = share * most_N;
    for (int i = 0; i < 100; ++i) block.step(kStep_s);
    const double expected_m_s = std::max(0.0, share - 1.0) * most_N / kMass_kg * 0.1;
    EXPECT_NEAR(block.velocity[0], expected_m_s, 1e-10) << share;
  }
}

// In space, sliding askew: friction opposes the velocity, whose direction stays.
TEST(Block, SlidesAlongItsVelocityInSpace) {
  constexpr double kFriction = 0.3, kStep_s = 1e-3;
  Bench block(one_body(BaseKind::kSpatial, {0.02, 0.03, 0.04}), {at({0, 0, 0}, kFriction)});
  block.velocity.head<2>() << 1.2, 0.9;
  for (int i = 0; i < 200; ++i) block.step(kStep_s);
  const double left_m_s = 1.5 - kFriction * kGravity_m_s2 * 0.2;
  EXPECT_NEAR(block.velocity[0], 0.8 * left_m_s, 1e-9);
  EXPECT_NEAR(block.velocity[1], 0.6 * left_m_s, 1e-9);
}

// Housner 1963: a slender block that rocks from corner to corner keeps 1 - 3/2 sin^2(alpha) of its
// rate at each impact, alpha = atan(width/height).
TEST(RockingBlock, KeepsHousnersShareOfItsRate) {
  constexpr double kHalfWidth_m = 0.05, kHalfTall_m = 0.25;
  const double square_m2 = kHalfWidth_m * kHalfWidth_m + kHalfTall_m * kHalfTall_m;
  const double inertia_kg_m2 = kMass_kg / 3.0 * square_m2;
  Bench block(
      one_body(BaseKind::kPlanar, {1, inertia_kg_m2, 1}),
      {at({-kHalfWidth_m, 0, -kHalfTall_m}, 5.0), at({kHalfWidth_m, 0, -kHalfTall_m}, 5.0)});
  constexpr double kTilt_rad = 0.1, kStep_s = 2e-5;
  // On its right corner, which stands at the origin's height.
  block.position[2] = kTilt_rad;
  block.position[1] = kHalfTall_m * std::cos(kTilt_rad) + kHalfWidth_m * std::sin(kTilt_rad);
  double before_rad_s = 0.0;
  for (int i = 0; i < 100000 && block.stepping.impulses_N_s()[2] == 0.0; ++i) {
    before_rad_s = block.velocity[2];
    block.step(kStep_s);
  }
  const double kept = 1.0 - 1.5 * kHalfWidth_m * kHalfWidth_m / square_m2;
  ASSERT_LT(before_rad_s, -0.5);
  EXPECT_NEAR(block.velocity[2] / before_rad_s, kept, 1e-3);
}

// Painlevé's rod, mu above 4/3 at the worst angle, sliding towards the ground it leans into: no
// finite force solves its equations; it stops at once, by an impulse that the step does not change.
TEST(PainleveRod, StopsAtOnceByAFiniteImpulse) {
  constexpr double kHalfRod_m = 0.5, kFriction = 3.0;
  const double inertia_kg_m2 = kMass_kg * kHalfRod_m * kHalfRod_m / 3.0;
  const auto jam = [&](double step_s, double* left_m_s) {
    Bench rod(one_body(BaseKind::kPlanar, {1, inertia_kg_m2, 1}),
              {at({0, 0, -kHalfRod_m}, kFriction)});
    constexpr double kLean_rad = -0.5;  // the foot is ahead of the centre, and slides ahead
    rod.position[2] = kLean_rad;
    rod.position[1] = kHalfRod_m * std::cos(kLean_rad);
    rod.velocity[0] = 1.0;
    const double before_J = rod.energy_J();
    rod.step(step_s);
    const VectorXd impulse = rod.stepping.impulses_N_s();
    EXPECT_LE(rod.energy_J(), before_J);
    EXPECT_TRUE(rod.bodies.set(rod.position, rod.velocity));
    *left_m_s = dynamics::point_velocity_m_s(rod.bodies.state(), {0, {0, 0, -kHalfRod_m}}).norm();
    return impulse.norm();
  };
  double left_m_s = 0.0;
  const double coarse_N_s = jam(1e-4, &left_m_s);
  EXPECT_NEAR(left_m_s, 0.0, 1e-3);
  const double fine_N_s = jam(1e-6, &left_m_s);
  EXPECT_NEAR(left_m_s, 0.0, 1e-5);
  EXPECT_GT(fine_N_s, 0.1);
  EXPECT_NEAR(coarse_N_s / fine_N_s, 1.0, 1e-2);
}

std::vector<GroundPoint> corners(double friction, double restitution) {
  std::vector<GroundPoint> points;
  for (const double x : {-0.1, 0.1}) {
    for (const double y : {-0.06, 0.06}) {
      for (const double z : {-0.04, 0.04}) points.push_back(at({x, y, z}, friction, restitution));
    }
  }
  return points;
}

// Thrown boxes: contact takes energy in every step.
TEST(Contact, NeverGivesEnergy) {
  std::mt19937 dice(7);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int box = 0; box < 20; ++box) {
    Bench bench(one_body(BaseKind::kSpatial, {0.004, 0.008, 0.01}),
                corners(0.5 + 0.5 * any(dice), 0.25 + 0.25 * any(dice)));
    bench.position[2] = 0.3;
    for (int i = 3; i < 7; ++i) bench.position[i] = any(dice);
    bench.position.segment<4>(3).normalize();
    for (int i = 0; i < 6; ++i) bench.velocity[i] = 5.0 * any(dice);
    for (int i = 0; i < 2000; ++i) {
      bench.step(5e-4);
      const VectorXd& p = bench.stepping.generalised_impulse();
      const double work_J = p.dot(bench.velocity) - 0.5 * p.dot(bench.stepping.jump());
      ASSERT_LE(work_J, 1e-12) << box << " " << i;
    }
    EXPECT_GT(bench.position[2], 0.038) << box;  // its half height, but for what a step sinks
  }
}

// A free arm of two links, torque-free: energy and momentum stay; errors fall as the fourth power.
TEST(Flight, IsOfFourthOrder) {
  dynamics::Tree tree = one_body(BaseKind::kPlanar, {0.1, 0.1, 0.1});
  dynamics::Body link;
  link.name = "link";
  link.inertia.mass_kg = 1.0;
  link.inertia.center_of_mass_m = {0, 0, -0.3};
  link.inertia.inertia_kg_m2 = Vector3d(0.02, 0.02, 0.02).asDiagonal();
  tree.bodies.push_back(link);
  const auto after_half_a_second = [&](int steps) {
    Bench bench(tree, {});
    bench.position[1] = 5.0;
    bench.velocity << 1.0, 2.0, 6.0, -9.0;
    for (int i = 0; i < steps; ++i) bench.step(0.5 / steps);
    return bench.position;
  };
  const VectorXd exact = after_half_a_second(4000);
  const double coarse = (after_half_a_second(50) - exact).norm();
  const double fine = (after_half_a_second(100) - exact).norm();
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.3);
}

// A body that tumbles in space: the axis of its rate turns.
TEST(Flight, IsOfFourthOrderInSpaceToo) {
  const auto after_half_a_second = [](int steps) {
    Bench bench(one_body(BaseKind::kSpatial, {0.05, 0.08, 0.11}), {});
    bench.velocity << 0, 0, 3, 2, 7, 1;
    for (int i = 0; i < steps; ++i) bench.step(0.5 / steps);
    return bench.position;
  };
  const VectorXd exact = after_half_a_second(4000);
  const double coarse = (after_half_a_second(50) - exact).norm();
  const double fine = (after_half_a_second(100) - exact).norm();
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.3);
}

TEST(Flight, KeepsAngularMomentum) {
  Bench bench(one_body(BaseKind::kSpatial, {0.05, 0.08, 0.11}), {});
  bench.velocity << 0, 0, 3, 2, 7, 1;
  ASSERT_TRUE(bench.bodies.set(bench.position, bench.velocity));
  const Vector3d before = dynamics::centroid(bench.bodies.state()).angular_momentum_Nm_s;
  for (int i = 0; i < 5000; ++i) bench.step(1e-4);
  ASSERT_TRUE(bench.bodies.set(bench.position, bench.velocity));
  const Vector3d after = dynamics::centroid(bench.bodies.state()).angular_momentum_Nm_s;
  EXPECT_LT((after - before).norm(), 1e-6);
}

TEST(Stepping, ChangesNothingWhereItFails) {
  Bench bench(one_body(BaseKind::kPlanar, {1, 1, 1}), {});
  bench.velocity[0] = 1e308;
  bench.force[0] = 1e308;
  const VectorXd before = bench.velocity;
  EXPECT_EQ(bench.stepping.step(bench.position, bench.velocity, bench.force, 1e3),
            TimeStepping::Outcome::kBlownUp);
  EXPECT_EQ(bench.velocity, before);
}

}  // namespace
}  // namespace torquewright::simulation
