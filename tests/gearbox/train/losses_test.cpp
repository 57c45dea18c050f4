// SPDX-License-Identifier: Apache-2.0
// Where the power goes. Oracles: conservation of power and torque; what a single lossy mesh takes.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "gearbox/topologies/planetary.hpp"
#include "gearbox/topologies/three_k.hpp"
#include "gearbox/train/power_flow.hpp"
#include "tests/gearbox/example_problem.hpp"
#include "tests/gearbox/train/random_trains.hpp"

namespace torquewright::gearbox {
namespace {

// A handful of roundings, grown a thousandfold (RandomTrains).
constexpr double kRounding = 1e-11;

double sum_of(const ThreeKLosses& losses) {
  return losses.sun_planet_1 + losses.planet_1_fixed_ring + losses.planet_2_output_ring;
}

bool is_loss(const ThreeKLosses& losses) {
  return losses.sun_planet_1 >= 0 && losses.planet_1_fixed_ring >= 0 &&
         losses.planet_2_output_ring >= 0;
}

TEST(Losses, SumToWhatTheTrainLoses) {
  test::RandomTrains trains(11);
  int locking = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const auto [first, second, mesh] = trains.next();
    const TrainEfficiency train = three_k_efficiency(first, second, mesh);
    const ThreeKLosses forward = three_k_forward_losses(first, second, mesh, train);
    ASSERT_TRUE(is_loss(forward));
    ASSERT_NEAR(sum_of(forward), 1 - train.forward, kRounding);
    const ThreeKLosses backward = three_k_backward_losses(first, second, mesh, train);
    ASSERT_TRUE(is_loss(backward));
    const bool locks = train.flow == PowerFlow::kSelfLocking;
    locking += locks ? 1 : 0;
    ASSERT_NEAR(sum_of(backward), locks ? 0 : 1 - train.backward, kRounding);
  }
  EXPECT_GT(locking, 100);
}

TEST(Losses, BelongToTheMeshThatHasThem) {
  const auto losses = [](const ThreeKMeshEfficiencies<double>& mesh) {
    return three_k_forward_losses(3.0, 0.8, mesh, three_k_efficiency(3.0, 0.8, mesh));
  };
  const ThreeKLosses sun = losses({0.97, 1.0, 1.0});
  EXPECT_NEAR(sun.sun_planet_1, 0.75 * 0.03, 1e-15);  // weight I1/(1 + I1), exact for this mesh
  EXPECT_EQ(sun.planet_1_fixed_ring, 0.0);
  EXPECT_EQ(sun.planet_2_output_ring, 0.0);
  const ThreeKLosses output = losses({1.0, 1.0, 0.97});
  EXPECT_NEAR(output.planet_2_output_ring, sum_of(output), 1e-15);
  EXPECT_GT(output.planet_2_output_ring, 0.1);
}

TEST(Losses, OfTheSingleStageSumToo) {
  for (const double ratio : {1.2, 4.0, 7.0}) {
    const PlanetaryMeshEfficiencies<double> mesh{0.97, 0.985};
    const TrainEfficiency train = planetary_efficiency(ratio, mesh);
    const PlanetaryLosses forward = planetary_forward_losses(ratio, mesh, train);
    const PlanetaryLosses backward = planetary_backward_losses(ratio, mesh, train);
    EXPECT_NEAR(forward.sun_planet + forward.planet_ring, 1 - train.forward, 1e-14);
    EXPECT_NEAR(backward.sun_planet + backward.planet_ring, 1 - train.backward, 1e-14);
    EXPECT_GT(forward.planet_ring, 0);
    EXPECT_GT(backward.planet_ring, 0);
  }
}

// Oracle: a separate program of twenty lines in Python, from the contact path to the shaft powers.
TEST(Losses, OfD151) {
  const DesignReport report = three_k::evaluate(test::knee(), {{44, 44, 32}, 4, Rational(3, 5)});
  EXPECT_NEAR(report.meshes[0].forward_loss, 0.006577538511955416, 1e-12);
  EXPECT_NEAR(report.meshes[1].forward_loss, 0.016280644958999214, 1e-12);
  EXPECT_NEAR(report.meshes[2].forward_loss, 0.02038760882687634, 1e-12);
  EXPECT_NEAR(report.forward_efficiency, 0.9567542077021693, 1e-12);
  EXPECT_NEAR(report.backward_efficiency, 0.9552021076343958, 1e-12);
}

TEST(Losses, WithoutFrictionHaveTheSharesOfTheirLimit) {
  Problem problem = test::knee();
  const Design design{{44, 44, 32}, 4, Rational(3, 5)};
  problem.friction_coefficient.reset();
  const DesignReport lossless = three_k::evaluate(problem, design);
  problem.friction_coefficient = Rational(1, 1000000);
  const DesignReport slight = three_k::evaluate(problem, design);
  for (std::size_t mesh = 0; mesh < 3; ++mesh) {
    EXPECT_EQ(lossless.meshes[mesh].forward_loss, 0.0);
    // first order in mu: 1e-6 times weights below 5
    EXPECT_NEAR(lossless.meshes[mesh].loss_share, slight.meshes[mesh].loss_share, 1e-5);
  }
  EXPECT_FALSE(lossless.driving_torque_Nm);
}

// Oracle: torques of sun, held ring and output add up to zero, torques times speeds too; with
// losses the output's power is the efficiency's share of the sun's.
TEST(PowerBalance, OfEveryReport) {
  std::mt19937 random(12);
  std::uniform_int_distribution<std::int64_t> count(20, 60);
  for (int trial = 0; trial < 300; ++trial) {
    const Design design{{count(random), count(random), count(random)}, 3, Rational(3, 5)};
    if (design.teeth[1] == design.teeth[2]) continue;
    const DesignReport report = three_k::evaluate(test::knee(), design);
    const double output_Nm = 320;
    const double output_speed = report.gears[4].speed_per_input;  // of a sun at 1 rad/s
    const double scale = std::abs(*report.input_torque_Nm) + output_Nm;
    EXPECT_NEAR(*report.input_torque_Nm + *report.fixed_ring_torque_Nm, output_Nm, 1e-12 * scale);
    EXPECT_NEAR(*report.input_torque_Nm, output_Nm * output_speed, 1e-12 * scale);
    EXPECT_NEAR(*report.driving_torque_Nm * report.forward_efficiency, output_Nm * output_speed,
                1e-12 * scale);
    EXPECT_NEAR(*report.backdriven_torque_Nm, output_Nm * output_speed * report.backward_efficiency,
                1e-12 * scale);
    EXPECT_NEAR(report.gears[1].speed_per_input, report.gears[2].speed_per_input, 0);
  }
}

TEST(PowerBalance, ASelfLockingTrainGivesNothingBack) {
  Problem problem = test::knee();
  problem.friction_coefficient = Rational(1, 2);
  const DesignReport report = three_k::evaluate(problem, {{44, 44, 42}, 4, Rational(3, 5)});
  EXPECT_TRUE(report.self_locking);
  EXPECT_EQ(report.backward_efficiency, 0.0);
  EXPECT_EQ(*report.backdriven_torque_Nm, 0.0);
  EXPECT_GT(*report.driving_torque_Nm, *report.input_torque_Nm);
  EXPECT_EQ(report.meshes[1].backward_loss, 0.0);
}

TEST(RotorInertia, IsKnownWithoutTheGears) {
  Problem problem = test::knee();
  EXPECT_FALSE(
      three_k::evaluate(problem, {{44, 44, 32}, 4, Rational(3, 5)}).rotor_inertia_at_output_kg_m2);
  problem.rotor_inertia_kg_m2 = Rational(922, 1000000);  // seed 001, table II
  const DesignReport report = three_k::evaluate(problem, {{44, 44, 32}, 4, Rational(3, 5)});
  EXPECT_NEAR(*report.rotor_inertia_at_output_kg_m2, .3688, 1e-15);
  EXPECT_FALSE(report.reflected_inertia_kg_m2);
}

TEST(Choices, OfTheProblemAreConstraints) {
  const Design design{{44, 44, 32}, 8, Rational(1, 2)};
  const DesignReport report = three_k::evaluate(test::knee(), design);
  const ConstraintReport* planets = test::find(report, "planet_count");
  ASSERT_NE(planets, nullptr);
  EXPECT_FALSE(planets->satisfied);
  EXPECT_EQ(planets->sentence,
            "planet_count: 8 planets; the problem offers 4; needs one of these.");
  EXPECT_EQ(planets->margin, -4);
  const ConstraintReport* module = test::find(report, "module");
  ASSERT_NE(module, nullptr);
  EXPECT_EQ(module->sentence, "module: 0.5 mm; the problem offers 0.6 mm; needs one of these.");
  EXPECT_EQ(test::find(three_k::evaluate(test::knee(), {{44, 44, 32}, 4, Rational(3, 5)}),
                       "planet_count"),
            nullptr);
}

}  // namespace
}  // namespace torquewright::gearbox
