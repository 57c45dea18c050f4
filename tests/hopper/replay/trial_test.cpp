// SPDX-License-Identifier: Apache-2.0
#include "hopper/trials/trial.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <functional>

#include "robot/parts/plausible_inertia.hpp"
#include "tests/hopper/replay/kolmogorov.hpp"
#include "tests/hopper/replay/randomised_hopper.hpp"

namespace torquewright::hopper {
namespace {

using test::hopper;
using test::seeds_tables;

constexpr std::uint64_t kSeedOfTrials = 20;
constexpr std::size_t kTrials = 2000;

/// The seed's tables and every other key.
Randomisation everything() {
  Randomisation all = seeds_tables();
  all.body_mass_factor = {{{0.9, 1.3}, {}, ""}};
  all.motor_strength_factor = {{{0.8, 1.1}, {"knee"}, ""}};
  all.ground_height_m = Range{-0.02, 0.01};
  all.latency_s = Range{0.0, 0.004};
  all.state_of_charge = Range{0.2, 1.0};
  all.initial_joint_position_rad = {{{-0.1, 0.1}, {}, ""}};
  all.initial_joint_velocity_rad_s = {{{-0.5, 0.25}, {"knee"}, ""}};
  return all;
}

/// A number of a trial, and between what it must lie.
struct Number {
  const char* name;
  Range range;
  std::function<double(const Trial&)> of;
};

std::vector<Number> numbers() {
  return {
      {"inertia of the calf", {0.85, 1.15}, [](const Trial& t) { return t.inertia_factor[1]; }},
      {"inertia of the foot", {0.85, 1.15}, [](const Trial& t) { return t.inertia_factor[3]; }},
      {"thigh's x", {-0.03, 0.03}, [](const Trial& t) { return t.center_of_mass_shift_m(0, 0); }},
      {"thigh's z", {-0.03, 0.03}, [](const Trial& t) { return t.center_of_mass_shift_m(2, 0); }},
      {"foot's x", {-0.03, 0.03}, [](const Trial& t) { return t.center_of_mass_shift_m(0, 3); }},
      {"knee's gain", {0.9, 1.1}, [](const Trial& t) { return t.controller_gain_factor[0]; }},
      {"knee's strength", {0.8, 1.1}, [](const Trial& t) { return t.motor_strength_factor[0]; }},
      {"knee's friction", {0.0, 0.7}, [](const Trial& t) { return t.further_friction_Nm[0]; }},
      {"ankle's friction", {0.0, 1.0}, [](const Trial& t) { return t.further_friction_Nm[2]; }},
      {"ground", {0.5, 0.9}, [](const Trial& t) { return *t.friction_coefficient; }},
      {"restitution", {0.0, 0.2}, [](const Trial& t) { return *t.restitution; }},
      {"height", {-0.02, 0.01}, [](const Trial& t) { return t.ground_height_m; }},
      {"latency", {0.0, 0.004}, [](const Trial& t) { return t.latency_s; }},
      {"charge", {0.2, 1.0}, [](const Trial& t) { return *t.state_of_charge; }},
      {"voltage", {0.93, 1.0}, [](const Trial& t) { return t.bus_voltage_factor; }},
      {"winding", {293.15, 353.15}, [](const Trial& t) { return *t.winding_temperature_K; }},
      {"ankle_roll", {-0.1, 0.1}, [](const Trial& t) { return t.initial_joint_position_rad[2]; }},
      {"knee's rate",
       {-0.5, 0.25},
       [](const Trial& t) { return t.initial_joint_velocity_rad_s[0]; }},
  };
}

std::vector<Trial> trials(const Randomisation& randomisation, std::size_t count) {
  std::vector<Trial> drawn;
  for (std::size_t i = 0; i < count; ++i) {
    drawn.push_back(draw_trial(randomisation, hopper(), kSeedOfTrials, i));
  }
  return drawn;
}

/// -1 at the least value, 1 at the greatest.
double centred(const Number& number, const Trial& trial) {
  const Range& range = number.range;
  return 2.0 * (number.of(trial) - range.least) / (range.greatest - range.least) - 1.0;
}

// Oracle: the uniform distribution between the document's ends. That none of 2000 draws comes
// within 1 % of an end has a chance of 0.99^2000 = 2e-9.
TEST(Trial, DrawsEveryNumberUniformlyBetweenItsEnds) {
  const std::vector<Trial> drawn = trials(everything(), kTrials);
  for (const Number& number : numbers()) {
    std::vector<double> shares;
    for (const Trial& trial : drawn) shares.push_back(0.5 * (centred(number, trial) + 1.0));
    const auto [least, greatest] = std::minmax_element(shares.begin(), shares.end());
    EXPECT_GE(*least, 0.0) << number.name;
    EXPECT_LT(*least, 0.01) << number.name;
    EXPECT_LE(*greatest, 1.0) << number.name;
    EXPECT_GT(*greatest, 0.99) << number.name;
    EXPECT_LT(test::distance_to([](double x) { return x; }, shares), test::distance_bound(kTrials))
        << number.name;
  }
}

// Oracle: products of independent numbers of mean 0 have mean 0; of two numbers of a trial, and of
// one number in trials beside each other.
TEST(Trial, DrawsNumbersThatKnowNothingOfEachOther) {
  constexpr std::size_t kMany = 20000;
  const std::vector<Trial> drawn = trials(everything(), kMany + 1);
  const std::vector<Number> all = numbers();
  for (std::size_t a = 0; a < all.size(); ++a) {
    for (std::size_t b = 0; b <= a; ++b) {
      double sum = 0.0;
      for (std::size_t i = 0; i < kMany; ++i) {
        sum += centred(all[a], drawn[i]) * centred(all[b], drawn[a == b ? i + 1 : i]);
      }
      EXPECT_LT(std::abs(sum / kMany), test::mean_bound(kMany, 2.0))
          << all[a].name << ", " << all[b].name;
    }
  }
}

// Oracle: both factors' means are 1 and 1.1, and they are independent.
TEST(Trial, DrawsOneTotalMassAndOneFactorOfEachBody) {
  double sum = 0.0;
  for (const Trial& trial : trials(everything(), kTrials)) sum += trial.mass_factor[1];
  EXPECT_NEAR(sum / kTrials, 1.1, test::mean_bound(kTrials, 1.15 * 1.3 - 0.85 * 0.9));
  for (const Trial& trial : trials(seeds_tables(), 100)) {
    EXPECT_EQ(trial.mass_factor.minCoeff(), trial.mass_factor.maxCoeff());
  }
}

void expect_same(const Trial& one, const Trial& other) {
  for (const Number& number : numbers()) {
    EXPECT_EQ(number.of(one), number.of(other)) << number.name;
  }
  EXPECT_EQ(one.mass_factor, other.mass_factor);
}

TEST(Trial, CanBeRepeatedByItself) {
  const std::vector<Trial> drawn = trials(everything(), 40);
  expect_same(draw_trial(everything(), hopper(), kSeedOfTrials, 31), drawn[31]);
  EXPECT_EQ(drawn[31].number, 31u);
  EXPECT_EQ(drawn[31].seed, kSeedOfTrials);
  const Trial of_other_seed = draw_trial(everything(), hopper(), kSeedOfTrials + 1, 31);
  for (const Number& number : numbers()) {
    EXPECT_NE(number.of(of_other_seed), number.of(drawn[31])) << number.name;
    EXPECT_NE(number.of(drawn[30]), number.of(drawn[31])) << number.name;
  }
}

// Fewer keys, another order of ranges, ranges that name what the others meant anyway, one body more
// before the others.
TEST(Trial, DrawsTheSameWhateverElseIsDrawn) {
  const Trial all = draw_trial(everything(), hopper(), kSeedOfTrials, 5);
  Randomisation few;
  few.body_inertia_factor = {{{0.85, 1.15}, {"foot"}, ""}};
  few.restitution = Range{0.0, 0.2};
  few.further_friction_Nm = {{{0.0, 1.0}, {"ankle_right", "ankle_left"}, ""},
                             {{0.0, 0.7}, {"knee"}, ""}};
  few.center_of_mass_shift_m = {{{{-0.03, 0.03}, {"thigh"}, ""}, {false, false, true}}};
  Robot taller = hopper();
  dynamics::Body extra = taller.tree.bodies.front();
  extra.name = "ballast";
  taller.tree.bodies.insert(taller.tree.bodies.begin(), extra);
  const Trial some = draw_trial(few, taller, kSeedOfTrials, 5);
  EXPECT_EQ(some.inertia_factor[4], all.inertia_factor[3]);
  EXPECT_EQ(some.inertia_factor[3], 1.0);  // no range is for the ankle's cross
  EXPECT_EQ(some.restitution, all.restitution);
  EXPECT_EQ(some.further_friction_Nm, all.further_friction_Nm);
  EXPECT_EQ(some.motor_strength_factor, Eigen::Vector3d::Ones());
  EXPECT_EQ(some.center_of_mass_shift_m(2, 1), all.center_of_mass_shift_m(2, 0));
  EXPECT_EQ(some.center_of_mass_shift_m(0, 1), 0.0);
  EXPECT_FALSE(some.friction_coefficient);
  EXPECT_EQ(some.latency_s, 0.0);
  EXPECT_EQ(some.ground_height_m, 0.0);
  EXPECT_EQ(some.bus_voltage_factor, 1.0);
}

// Oracle: a mass, an inertia and contacts of real bodies (inertia_objection), and the numbers
// drawn.
TEST(Perturbed, IsARealRobotInEveryTrial) {
  for (const Trial& trial : trials(everything(), kTrials)) {
    const Robot changed = perturbed(hopper(), trial);
    ASSERT_NO_THROW(dynamics::require_tree(changed.tree));
    for (std::size_t i = 0; i < changed.tree.bodies.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      const dynamics::RigidInertia& now = changed.tree.bodies[i].inertia;
      const dynamics::RigidInertia& was = hopper().tree.bodies[i].inertia;
      ASSERT_FALSE(inertia_objection(now.inertia_kg_m2));
      ASSERT_EQ(now.mass_kg, was.mass_kg * trial.mass_factor[at]);
      ASSERT_EQ(now.center_of_mass_m,
                Eigen::Vector3d(was.center_of_mass_m + trial.center_of_mass_shift_m.col(at)));
      ASSERT_EQ(now.inertia_kg_m2, Eigen::Matrix3d(was.inertia_kg_m2 * trial.inertia_factor[at]));
    }
    for (const ContactPoint& contact : changed.contacts) {
      ASSERT_EQ(contact.friction_coefficient, trial.friction_coefficient);
      ASSERT_EQ(contact.restitution, trial.restitution);
    }
  }
}

// Oracle: a flat plate, whose greatest moment is the sum of the others: the border of what is real.
TEST(Perturbed, KeepsAPlateAPlate) {
  Robot robot = hopper();
  robot.tree.bodies[0].inertia.inertia_kg_m2 = Eigen::Vector3d(0.1, 0.2, 0.3).asDiagonal();
  for (std::size_t i = 0; i < kTrials; ++i) {
    const Robot changed = perturbed(robot, draw_trial(everything(), robot, kSeedOfTrials, i));
    ASSERT_FALSE(inertia_objection(changed.tree.bodies[0].inertia.inertia_kg_m2));
  }
}

TEST(Perturbed, LeavesAloneWhatNothingDraws) {
  const Robot same = perturbed(hopper(), draw_trial({}, hopper(), kSeedOfTrials, 0));
  for (std::size_t i = 0; i < same.tree.bodies.size(); ++i) {
    EXPECT_EQ(same.tree.bodies[i].inertia.mass_kg, hopper().tree.bodies[i].inertia.mass_kg);
    EXPECT_EQ(same.tree.bodies[i].inertia.center_of_mass_m,
              hopper().tree.bodies[i].inertia.center_of_mass_m);
  }
  EXPECT_EQ(same.contacts[0].friction_coefficient, hopper().contacts[0].friction_coefficient);
  EXPECT_EQ(same.drivetrains[0].actuators[0].battery, hopper().drivetrains[0].actuators[0].battery);
  EXPECT_THROW((void)perturbed(hopper(), Trial{}), std::invalid_argument);
}

// Oracle: the battery's open circuit is 16 cells of 4.2 V, times the factor; all drives still share
// one battery.
TEST(Perturbed, ScalesTheVoltageOfBatteryAndBus) {
  const Trial trial = draw_trial(seeds_tables(), hopper(), kSeedOfTrials, 3);
  ASSERT_LT(trial.bus_voltage_factor, 1.0);
  const Robot changed = perturbed(hopper(), trial);
  const actuator::OperatingConditions conditions = conditions_of(trial, {});
  EXPECT_EQ(conditions.winding_temperature_K, trial.winding_temperature_K);
  for (const Drivetrain& drivetrain : changed.drivetrains) {
    for (const actuator::Actuator& drive : drivetrain.actuators) {
      EXPECT_DOUBLE_EQ(open_circuit_voltage_V(drive, conditions),
                       16 * 4.2 * trial.bus_voltage_factor);
      EXPECT_EQ(drive.battery, changed.drivetrains[0].actuators[0].battery);
    }
  }
}

// Oracle: the definitions in trial.hpp.
TEST(ConditionsOf, PutWhatWasDrawnInThePlaceOfWhatWasGiven) {
  Trial trial;
  trial.bus_voltage_factor = 0.5;
  actuator::OperatingConditions given;
  given.bus_voltage_V = 60.0;
  given.winding_temperature_K = 300.0;
  EXPECT_EQ(conditions_of(trial, given).bus_voltage_V, 30.0);
  EXPECT_EQ(conditions_of(trial, given).winding_temperature_K, 300.0);
  trial.state_of_charge = 0.7;
  trial.winding_temperature_K = 350.0;
  EXPECT_EQ(conditions_of(trial, given).bus_voltage_V, std::nullopt);
  EXPECT_EQ(conditions_of(trial, given).state_of_charge, 0.7);
  EXPECT_EQ(conditions_of(trial, given).winding_temperature_K, 350.0);
}

}  // namespace
}  // namespace torquewright::hopper
