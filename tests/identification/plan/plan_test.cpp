// SPDX-License-Identifier: Apache-2.0
// A plan is inside the region at every sample, the same every time, no worse than the chirp for
// what it is made for, and its standard errors are what repeated fits scatter by.
#include "identification/experiment/plan.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <random>

#include "actuator/motor/actuator_spec.hpp"
#include "identification/experiment/plan_trial.hpp"
#include "identification/forward/candidates.hpp"
#include "identification/forward/torque_prediction.hpp"
#include "identification/preparation/preparation.hpp"
#include "identification/simulated/rig_plant.hpp"
#include "io/faults/spec_error.hpp"
#include "simulation/run/simulate.hpp"

namespace torquewright::identification {
namespace {

actuator::Actuator bench_actuator() {
  return actuator::read_actuator(TORQUEWRIGHT_SOURCE_DIR "/specs/log/bench_actuator.json").actuator;
}

Rig bench_rig() {
  return read_rig(io::read_document(TORQUEWRIGHT_SOURCE_DIR "/specs/log/bench_rig.json", "rig"));
}

PlanOptions asked(std::vector<std::string> effects) {
  PlanOptions options;
  options.separate = std::move(effects);
  options.duration_s = 16.0;
  options.candidates = 8;
  return options;
}

const Plan& stribeck_plan() {
  static const Plan plan = plan_excitation(bench_rig(), bench_actuator(),
                                           asked({"stribeck_friction", "coulomb_friction"}));
  return plan;
}

TEST(Plan, IsInsideTheRegionAtEverySample) {
  const actuator::Actuator actuator = bench_actuator();
  const actuator::Region region(actuator, {});
  for (const ExcitationRun& run : stribeck_plan().runs) {
    // By the simulation's own step, finer than the search's.
    const simulation::SimulatedRun simulated =
        simulation::simulate(*plant_of(bench_rig().load), {&actuator}, run.excitation, {run.start});
    const simulation::JointTrace& trace = simulated.joints[0];
    for (std::size_t i = 0; i < trace.torque_Nm.size(); ++i) {
      const actuator::JointRange range = region.at(trace.speed_rad_s[i]);
      ASSERT_FALSE(range.is_empty);
      ASSERT_LE(trace.torque_Nm[i], range.greatest.torque_Nm);
      ASSERT_GE(trace.torque_Nm[i], range.least.torque_Nm);
      ASSERT_LE(std::abs(trace.current_A[i]), actuator.drive.peak_current_A);
    }
  }
}

TEST(Plan, KeepsToTheRigsLimits) {
  PlanOptions options = asked({"coulomb_friction", "viscous_friction"});
  options.limits.position_rad = 0.5;
  options.limits.speed_rad_s = 3.0;
  options.candidates = 2;
  const actuator::Actuator actuator = bench_actuator();
  for (const ExcitationRun& run : plan_excitation(bench_rig(), actuator, options).runs) {
    const simulation::SimulatedRun simulated =
        simulation::simulate(*plant_of(bench_rig().load), {&actuator}, run.excitation, {run.start});
    for (std::size_t i = 0; i < run.excitation.time_s.size(); ++i) {
      ASSERT_LE(std::abs(simulated.joints[0].position_rad[i]), 0.5);
      ASSERT_LE(std::abs(simulated.joints[0].speed_rad_s[i]), 3.0);
    }
  }
}

// What is simulated while searching does not grow with the length without end: drawn and refined
// ones together are at most twice kMostTried_s. Short plans are searched as asked.
TEST(Plan, TriesLongOnesLessOften) {
  PlanOptions options;
  EXPECT_EQ(tries_of(options), options.candidates);
  for (const double duration_s : {8.0, 240.0, 241.0, 600.0}) {
    options.duration_s = duration_s;
    EXPECT_LE(static_cast<double>(tries_of(options)) * duration_s, kMostTried_s) << duration_s;
    EXPECT_GE(tries_of(options), 2u);
  }
  options.candidates = 2;  // as asked for below the bound, at any length
  EXPECT_EQ(tries_of(options), 2u);
}

TEST(Plan, IsTheSameEveryTime) {
  const Plan again = plan_excitation(bench_rig(), bench_actuator(),
                                     asked({"stribeck_friction", "coulomb_friction"}));
  EXPECT_EQ(excitation_csv(again.runs), excitation_csv(stribeck_plan().runs));
}

TEST(Plan, ExpectsLessErrorThanTheChirp) {
  for (const PlannedParameter& each : stribeck_plan().parameters) {
    EXPECT_LT(each.plan.standard_error, each.chirp.standard_error) << each.column.effect;
  }
  EXPECT_TRUE(stribeck_plan().is_separable());
}

/// Of the parameter that is worst off, as plan.cpp has it: typical value over its error, and its
/// share.
double worst(const Plan& plan, Expected PlannedParameter::*which) {
  double least = 1e300;
  for (const PlannedParameter& each : plan.parameters) {
    const Expected& expected = each.*which;
    least = std::min(least, each.typical / expected.standard_error * std::min(expected.share, 0.5));
  }
  return least;
}

// On a wheel that only accelerates a chirp is good for friction; it is a candidate itself, so that
// nothing worse comes out. What is nearest to one coefficient may be the other of the same effect.
TEST(Plan, IsNeverWorseThanTheChirpForWhatIsWorstOff) {
  const Rig rig =
      read_rig(io::read_document(TORQUEWRIGHT_SOURCE_DIR "/specs/rig/free_flywheel.json", "rig"));
  for (const std::string effect : {"quadratic_drag", "load_dependent_friction"}) {
    PlanOptions options = asked({effect});
    options.duration_s = 8.0;
    options.candidates = 2;
    const Plan plan = plan_excitation(rig, bench_actuator(), options);
    EXPECT_GE(worst(plan, &PlannedParameter::plan), worst(plan, &PlannedParameter::chirp))
        << effect;
    for (const PlannedParameter& each : plan.parameters) {
      const bool is_itself = each.plan.nearest == each.column.effect &&
                             each.plan.nearest_parameter == each.column.parameter;
      EXPECT_FALSE(is_itself) << effect;
    }
  }
}

// Oracle: where only the angle is noisy, what is seen of a torque is the noise's second derivative
// times all the inertia that turns, wheel and rotor: errors are as those inertias, but for
// rounding.
TEST(Plan, ErrorsByTheAnglesNoiseGrowWithTheLoadsInertia) {
  PlanOptions options = asked({"coulomb_friction"});
  options.duration_s = 8.0;
  options.candidates = 1;
  options.noise = {{Quantity::kMotorCurrent, 0.0}, {Quantity::kMotorPosition, 1e-3}};
  Rig rig =
      read_rig(io::read_document(TORQUEWRIGHT_SOURCE_DIR "/specs/rig/free_flywheel.json", "rig"));
  const auto error = [&](double inertia_kg_m2) {
    rig.load.inertia_kg_m2 = inertia_kg_m2;
    return plan_excitation(rig, bench_actuator(), options).parameters[0].chirp.standard_error;
  };
  const actuator::Actuator actuator = bench_actuator();
  const double rotor_kg_m2 =
      std::pow(actuator.transmission.ratio, 2) * actuator.motor.rotor_inertia_kg_m2;
  const double expected = (1.0 + rotor_kg_m2) / (0.1 + rotor_kg_m2);  // 8.83
  EXPECT_NEAR(error(1.0) / error(0.1), expected, 1e-12 * expected);
}

TEST(Plan, RefusesToExpectErrorsWithoutNoise) {
  PlanOptions options = asked({"coulomb_friction"});
  options.noise = {{Quantity::kOutputPosition, 0.0},
                   {Quantity::kMotorCurrent, 0.0},
                   {Quantity::kOutputTorque, 0.0}};
  EXPECT_THROW(plan_excitation(bench_rig(), bench_actuator(), options), io::SpecError);
}

TEST(Plan, SaysThatAnExactIdentityIsNotSeparable) {
  const Plan plan = plan_excitation(bench_rig(), bench_actuator(),
                                    asked({"torque_offset", "asymmetric_friction"}));
  EXPECT_FALSE(plan.is_separable());
  ASSERT_EQ(plan.unseen.size(), 1u);
  EXPECT_NE(plan.unseen[0].remedy.find("tare"), std::string::npos);
}

Log played(const Plan& plan, const Rig& rig, const actuator::Actuator& actuator) {
  std::vector<simulation::SimulatedRun> simulated;
  for (const ExcitationRun& run : plan.runs) {
    simulated.push_back(
        simulation::simulate(*plant_of(rig.load), {&actuator}, run.excitation, {run.start}));
  }
  return noiseless_log(rig, actuator, plan.runs, simulated);
}

// A parameter that moves nothing while there is nothing of its effect has no column: it would be
// one of zeros, and nothing beside it could be told.
TEST(PlannedColumns, LeaveOutWhatMovesNothing) {
  const Rig rig = bench_rig();
  const actuator::Actuator actuator = bench_actuator();
  const Log log = played(stribeck_plan(), rig, actuator);
  const Bench bench = make_bench(rig, log, 0, {&actuator});
  const actuator::Ranges ranges = ranges_of(bench, prepare(log, bench, {}, {}));
  const std::vector<PlannedColumn> eddy = planned_columns(bench, ranges, "eddy_current_drag");
  ASSERT_EQ(eddy.size(), 1u);
  EXPECT_EQ(eddy[0].parameter, "peak_Nm");
  EXPECT_TRUE(eddy[0].at.starts_with("at critical_rad_s ")) << eddy[0].at;
  EXPECT_EQ(planned_columns(bench, ranges, "load_dependent_friction").size(), 2u);
  EXPECT_EQ(planned_columns(bench, ranges, "gear_ripple").size(), 2u);
}

TEST(Plan, RefusesAnUnknownNameWithTheNearest) {
  try {
    plan_excitation(bench_rig(), bench_actuator(), asked({"viscous_fricton"}));
    FAIL();
  } catch (const io::SpecError& error) {
    EXPECT_NE(std::string(error.what()).find("\"viscous_friction\""), std::string::npos);
  }
}

/// A fit of coulomb and viscous friction and an offset to a noisy log, by least squares.
Eigen::VectorXd fitted(const Log& clean, const Plan& plan, const Bench& bench,
                       const std::vector<PlannedColumn>& columns, std::mt19937_64& random) {
  Log noisy = clean;
  NoiseLevels levels{};
  for (const auto& [quantity, sigma] : plan.noise) {
    levels[static_cast<std::size_t>(quantity)] = sigma;
    std::normal_distribution<double> noise(0.0, sigma);
    for (std::size_t r = 0; r < noisy.runs.size(); ++r) {
      noisy.runs.change(r, [&, quantity = quantity](Run& run) {
        for (double& value : run.joints[0][quantity]) value += noise(random);
      });
    }
  }
  const std::vector<Signals> signals = prepare(noisy, bench, levels, {});
  const Rows rows(signals, std::vector<std::size_t>(noisy.runs.size(), 0), {});
  Hypothesis stated;
  stated.actuator = bench.actuator();
  stated.rig = *bench.rig;
  const Eigen::VectorXd residual = rows.values(
      [&](const Signals& stretch) { return torque_balance_Nm(bench, stated, stretch); });
  const Eigen::MatrixXd columns_at = planned_rows(bench, rows, columns);
  return columns_at.colPivHouseholderQr().solve(residual);
}

// Oracle: the laws of docs/effects.md by hand. Behind a gear without losses a sensor misses as much
// as friction takes, and what a saturation leaves out of the motor's torque.
TEST(PlannedColumns, AreTheLawsBehindAGearWithoutLosses) {
  const Rig rig = bench_rig();
  const actuator::Actuator actuator = bench_actuator();
  const Log log = played(stribeck_plan(), rig, actuator);
  const Bench bench = make_bench(rig, log, 0, {&actuator});
  const std::vector<Signals> signals = prepare(log, bench, {}, {});
  const Rows rows(signals, std::vector<std::size_t>(log.runs.size(), 0), {});
  const actuator::Ranges ranges = ranges_of(bench, signals);
  const double per_ampere_Nm = actuator.transmission.ratio * actuator.motor.torque_constant_Nm_A;
  const auto expect = [&](const std::string& effect, std::size_t index, const auto& law) {
    const std::vector<PlannedColumn> columns = planned_columns(bench, ranges, effect);
    ASSERT_GT(columns.size(), index) << effect;
    const Eigen::VectorXd found = planned_rows(bench, rows, {columns[index]});
    const Eigen::VectorXd known = rows.values([&](const Signals& stretch) {
      std::vector<double> values;
      for (std::size_t i = 0; i < stretch.size(); ++i) {
        actuator::Instant seen = stretch.at[i];
        seen.direction = stretch.filtered_direction[i];
        values.push_back(law(seen));
      }
      return values;
    });
    ASSERT_GT(known.norm(), 0.0) << effect;
    // Torques of some 50 Nm, rounded, over differences of a ten-thousandth of the largest.
    EXPECT_LT((found - known).norm(), 1e-9 * known.norm()) << effect << " " << index;
  };
  using At = actuator::Instant;
  const double slow_rad_s = 0.05 * ranges.speed_rad_s;
  expect("viscous_friction", 0, [](const At& at) { return -at.speed_rad_s; });
  expect("coulomb_friction", 0, [](const At& at) { return -at.direction; });
  expect("stribeck_friction", 0, [&](const At& at) {
    return -at.direction * std::exp(-std::pow(at.speed_rad_s / slow_rad_s, 2));
  });
  // Half of the difference more forward, half less backward: the same torque both ways.
  expect("asymmetric_friction", 0, [](const At&) { return -0.5; });
  expect("asymmetric_friction", 1,
         [](const At& at) { return -0.5 * at.direction * at.speed_rad_s; });
  expect("torque_constant_saturation", 0, [&](const At& at) {
    const double x = at.current_A / ranges.current_A;
    return -per_ampere_Nm * at.current_A * (1.0 - 1.0 / std::sqrt(1.0 + x * x));
  });
  expect("eddy_current_drag", 0, [&](const At& at) {
    const double x = at.speed_rad_s / (0.4 * ranges.speed_rad_s);
    return -2.0 * x / (1.0 + x * x);
  });
  expect("parallel_spring", 0, [](const At& at) { return -at.output_angle_rad; });
  expect("torque_offset", 0, [](const At&) { return 1.0; });
}

TEST(Plan, StandardErrorsAreTheScatterOfRepeatedFits) {
  const Rig rig = bench_rig();
  const actuator::Actuator actuator = bench_actuator();
  const Plan plan = plan_excitation(rig, actuator, asked({"coulomb_friction", "viscous_friction"}));
  const Log clean = played(plan, rig, actuator);
  const Bench bench = make_bench(rig, clean, 0, {&actuator});
  const actuator::Ranges ranges = ranges_of(bench, prepare(clean, bench, {}, {}));
  std::vector<PlannedColumn> columns;
  for (const char* effect : {"coulomb_friction", "viscous_friction", "torque_offset"}) {
    const auto own = planned_columns(bench, ranges, effect);
    columns.insert(columns.end(), own.begin(), own.end());
  }
  constexpr int kFits = 40;
  std::mt19937_64 random(7);
  Eigen::MatrixXd fits(kFits, 3);
  for (int k = 0; k < kFits; ++k) {
    fits.row(k) = fitted(clean, plan, bench, columns, random).transpose();
  }
  for (Eigen::Index p = 0; p < 2; ++p) {
    const double mean = fits.col(p).mean();
    const double variance = (fits.col(p).array() - mean).square().sum() / (kFits - 1);
    const double expected = plan.parameters[static_cast<std::size_t>(p)].plan.standard_error;
    // Of chi-square with 39 degrees of freedom, 99.9 % lie between 16.3 and 76.0; beside that the
    // information takes noise near the band's edge, and that of the columns, only roughly: 15 %.
    const double ratio = variance / (expected * expected);
    EXPECT_GT(ratio, 16.3 / 39.0 * 0.75);
    EXPECT_LT(ratio, 76.0 / 39.0 * 1.32);
  }
}

}  // namespace
}  // namespace torquewright::identification
