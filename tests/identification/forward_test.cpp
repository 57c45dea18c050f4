// SPDX-License-Identifier: Apache-2.0
// The forward balance against closed forms, and a fit of it against the truth that was put in.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <string>

#include "actuator/effects/library.hpp"
#include "identification/forward/candidates.hpp"
#include "identification/forward/plain_forward.hpp"
#include "identification/forward/torque_forward.hpp"
#include "identification/forward/torque_prediction.hpp"
#include "identification/forward/winding_current.hpp"
#include "identification/preparation/held_signals.hpp"
#include "identification/selection/comparison.hpp"
#include "identification/selection/folds.hpp"
#include "identification/selection/search.hpp"
#include "tests/identification/made_bench.hpp"

namespace torquewright::identification::forward_test {
namespace {

using made::Made;
using made::MadeBench;

actuator::Effect effect(const char* name, std::vector<double> values) {
  return {actuator::find_effect(name), std::move(values), {}, false, ""};
}

/// One instant of a dynamometer, turning forward or for `forward` of its time.
struct OneInstant {
  actuator::Actuator actuator;
  Rig rig;
  Bench bench;
  Signals signals;

  OneInstant(double current_A, double forward) {
    actuator.motor.torque_constant_Nm_A = 0.5;
    actuator.transmission.ratio = 4.0;
    bench.rig = &rig;
    bench.actuators = {&actuator};
    bench.drive = Drive::kCurrent;
    bench.load_side = LoadSide::kSensor;
    signals.step_s = 0.01;
    signals.at.resize(1);
    signals.at[0].current_A = current_A;
    signals.at[0].direction = 2.0 * forward - 1.0;
    signals.load_side_Nm = {0.0};
  }
  double predicted_Nm() const {
    return -torque_balance_Nm(bench, {actuator, rig, {}}, signals).front();
  }
};

// Oracle: the contract's order of losses, tau = eta/(1 + k) (N tau_m - drag) driving, and
// |tau| = (N |tau_m| + drag) / (eta_b (1 - k)) driven back.
TEST(ForwardBalance, LosesInTheContractsOrder) {
  OneInstant driving(10.0, 1.0), driven(10.0, 0.0);
  for (OneInstant* each : {&driving, &driven}) {
    each->actuator.transmission.forward_efficiency = 0.9;
    each->actuator.transmission.backward_efficiency = 0.8;
    each->actuator.effects = {effect("coulomb_friction", {2.0}),
                              effect("load_dependent_friction", {0.25, 0.1})};
  }
  EXPECT_NEAR(driving.predicted_Nm(), 0.9 / 1.25 * (20.0 - 2.0), 1e-12);
  EXPECT_NEAR(driven.predicted_Nm(), (20.0 + 2.0) / (0.8 * 0.9), 1e-12);
}

// Oracle: the mean over time of both closed forms: three quarters of it forward.
TEST(ForwardBalance, CountsBothDirectionsByTheirShareOfTime) {
  OneInstant turning(10.0, 0.75);
  turning.actuator.transmission.forward_efficiency = 0.9;
  turning.actuator.transmission.backward_efficiency = 0.8;
  turning.actuator.effects = {effect("coulomb_friction", {2.0})};
  EXPECT_NEAR(turning.predicted_Nm(), 0.75 * 0.9 * 18.0 + 0.25 * 22.0 / 0.8, 1e-12);
}

// Oracle: closed form. (V - dead time - Ke N w) / (R + R_bus duty^2), the bus not being logged.
TEST(ForwardBalance, TakesTheCurrentFromTheVoltageWithDeadTimeAndSag) {
  OneInstant bench(0.0, 1.0);
  bench.actuator.motor.resistance_ohm = 0.4;
  bench.actuator.drive.bus_voltage_V = 48.0;
  bench.actuator.effects = {effect("inverter_dead_time", {0.5}), effect("voltage_sag", {0.2})};
  bench.bench.drive = Drive::kVoltage;
  bench.bench.drive_channel = Quantity::kDuty;
  actuator::Instant at;
  at.speed_rad_s = 2.0;
  const double duty = 0.5, back_emf_V = 0.5 * 4.0 * 2.0;
  const Currents currents =
      winding_currents(bench.bench, bench.actuator, bench.signals, {duty * 48.0}, {at}, 0.0);
  EXPECT_NEAR(currents.current_A[0], (24.0 - 0.5 - back_emf_V) / (0.4 + 0.2 * duty * duty), 1e-12);
}

// Oracle: the response of a first-order lag to a sine, amplitude 1/sqrt(1 + x^2), phase -atan(x).
TEST(ForwardBalance, LagsAsAFirstOrderLagDoes) {
  OneInstant bench(0.0, 1.0);
  const double lag_s = 0.0018, rad_s = 2.0 * std::numbers::pi * 5.0;
  bench.actuator.effects = {effect("torque_lag", {lag_s})};
  bench.signals.at.resize(400);
  bench.signals.load_side_Nm.assign(400, 0.0);
  for (std::size_t i = 0; i < 400; ++i) {
    bench.signals.at[i].current_A = std::sin(rad_s * 0.01 * static_cast<double>(i));
    bench.signals.at[i].direction = 1.0;
  }
  const std::vector<double> left =
      torque_balance_Nm(bench.bench, {bench.actuator, bench.rig, {}}, bench.signals);
  const double x = rad_s * lag_s;
  // Of a sine: what a cubic misses between samples, and a chord within a quarter of a step.
  const double step = rad_s * 0.01, quarter = 0.25 * step;
  const double missed = 2.0 * (3.0 / 128.0 * std::pow(step, 4) + quarter * quarter / 8.0);
  for (std::size_t i = 50; i < 390; ++i) {
    const double expected =
        2.0 / std::hypot(1.0, x) * std::sin(rad_s * 0.01 * static_cast<double>(i) - std::atan(x));
    EXPECT_NEAR(-left[i], expected, missed) << i;
  }
}

// Oracle: the gain of the signals' filter at its cut-off, one half; and a wave of more than half a
// turn in a sample shows nowhere.
TEST(ForwardBalance, HoldsWavesAsTheirFilterLeavesThem) {
  constexpr double kCutoff_Hz = 25.0, kOrder = 7.0, kAmplitude_Nm = 0.3;
  OneInstant bench(0.0, 1.0);
  actuator::Effect ripple = effect("gear_ripple", {});
  ripple.harmonics = {{kOrder, kAmplitude_Nm, 0.5 * std::numbers::pi}};
  bench.actuator.effects = {ripple};
  const auto predicted_Nm = [&](double frequency_Hz) {
    bench.signals.at[0].speed_rad_s = 2.0 * std::numbers::pi * frequency_Hz / kOrder;
    return bench.predicted_Nm();
  };
  EXPECT_NEAR(predicted_Nm(kCutoff_Hz), kAmplitude_Nm, 1e-12);
  bench.signals.cutoff_Hz = kCutoff_Hz;
  bench.signals.sample_step_s = 0.001;
  EXPECT_NEAR(predicted_Nm(1e-3), kAmplitude_Nm, 1e-12);
  EXPECT_NEAR(predicted_Nm(kCutoff_Hz), 0.5 * kAmplitude_Nm, 1e-12);
  EXPECT_EQ(predicted_Nm(0.51 / bench.signals.step_s), 0.0);
}

using Named = std::map<std::string, FoundParameters>;

/// What a search finds in an equation of a log: effects, with their parameters as reported.
Named found_in(const Log& log, const MadeBench& rig,
               const std::function<ForwardEquation(const Bench&, const std::vector<Signals>&,
                                                   const std::vector<std::size_t>&)>& equation_of) {
  const Bench bench = rig.bench(log);
  const NoiseLevels levels = noise_levels(log, 0);
  const HeldSignals held = held_signals(log, bench, levels, 1);
  const std::vector<std::size_t> folds = run_folds(log);
  const ForwardEquation equation = equation_of(bench, held.rows, folds);
  const Rows rows(held.rows, folds, {});
  const ModelFitter fitter(equation, rows, held.replica);
  const Found found = Search(fitter, {}).run();
  Named named;
  for (std::size_t m = 0; m < found.best.members.size(); ++m) {
    const EffectCandidate& member = *found.best.members[m];
    const double* first = found.best.coordinates.data() + found.best.first_of(m);
    named[member.effect] = member.report({first, member.parameters.size()});
  }
  return named;
}

Named found_in(const std::function<double(const Made&)>& added, const MadeBench& rig = {},
               double late_s = 0.0) {
  return found_in(rig.log(added, 0.01, late_s), rig, torque_forward);
}

// Oracle: the two coefficients that were put in, by the sign of the motion and by its speed.
TEST(ForwardSearch, FindsCoulombAndViscousFrictionAndNothingElse) {
  auto found = found_in(
      [](const Made& at) { return -0.4 * made::sign(at.speed_rad_s) - 0.08 * at.speed_rad_s; });
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found["coulomb_friction"].value("coulomb_Nm", NAN), 0.4, 0.004);
  EXPECT_NEAR(found["viscous_friction"].value("viscous_Nm_s_rad", NAN), 0.08, 0.0008);
}

/// Drag of eddy currents with its peak at `critical_rad_s`; the made motion reaches 6 rad/s.
std::function<double(const Made&)> eddy_currents(double peak_Nm, double critical_rad_s) {
  return [=](const Made& at) {
    const double x = at.speed_rad_s / critical_rad_s;
    return -2.0 * peak_Nm * x / (1.0 + x * x);
  };
}

TEST(ForwardSearch, FindsEddyCurrentDragThatPassesItsPeak) {
  auto found = found_in(eddy_currents(0.6, 2.0));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found["eddy_current_drag"].value("peak_Nm", NAN), 0.6, 0.006);
  EXPECT_NEAR(found["eddy_current_drag"].value("critical_rad_s", NAN), 2.0, 0.02);
}

// At a fiftieth of the critical speed it is viscous friction but for 0.04 %.
TEST(ForwardSearch, CallsSlowEddyCurrentDragViscous) {
  auto found = found_in(eddy_currents(15.0, 300.0));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found["viscous_friction"].value("viscous_Nm_s_rad", NAN), 0.1, 0.001);
}

// What the document states of viscous friction stays beside it.
TEST(ForwardSearch, FindsEddyCurrentDragBesideStatedViscousFriction) {
  MadeBench rig;
  rig.actuator.effects = {effect("viscous_friction", {0.1})};
  auto found = found_in(
      [drag = eddy_currents(0.6, 2.0)](const Made& at) { return drag(at) - 0.1 * at.speed_rad_s; },
      rig);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found["eddy_current_drag"].value("peak_Nm", NAN), 0.6, 0.006);
}

TEST(ForwardSearch, FindsAParallelSpring) {
  auto found = found_in([](const Made& at) { return -0.2 * (at.angle_rad - 0.5); });
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found["parallel_spring"].value("stiffness_Nm_rad", NAN), 0.2, 0.002);
  EXPECT_NEAR(found["parallel_spring"].value("neutral_angle_rad", NAN), 0.5, 0.02);
}

TEST(ForwardSearch, FindsTheStopsAtBothEnds) {
  auto found = found_in([](const Made& at) {
    return -3.0 * std::max(0.0, at.angle_rad - 3.4) + 2.0 * std::max(0.0, -3.0 - at.angle_rad);
  });
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found["upper_end_stop"].value("stiffness_Nm_rad", NAN), 3.0, 0.03);
  EXPECT_NEAR(found["upper_end_stop"].value("angle_rad", NAN), 3.4, 0.01);
  EXPECT_NEAR(found["lower_end_stop"].value("stiffness_Nm_rad", NAN), 2.0, 0.02);
  EXPECT_NEAR(found["lower_end_stop"].value("angle_rad", NAN), -3.0, 0.01);
}

TEST(ForwardSearch, NamesNothingWhereNothingIsMissing) {
  EXPECT_TRUE(found_in([](const Made&) { return 0.0; }).empty());
}

// Samples are 5 ms apart, and at which instant of these a channel was read no log says.
TEST(ForwardSearch, CallsLessThanHalfASampleNoDelay) {
  const auto nothing = [](const Made&) { return 0.0; };
  EXPECT_TRUE(found_in(nothing, {}, 0.002).empty());
  auto found = found_in(nothing, {}, 0.005);
  ASSERT_EQ(found.size(), 1u);
  // So slow a motion hardly tells a delay from a lag.
  const auto& [name, parameters] = *found.begin();
  ASSERT_TRUE(name == "channel_delay" || name == "torque_lag") << name;
  const char* late_s = name == "torque_lag" ? "time_constant_s" : "delay_s";
  EXPECT_NEAR(parameters.value(late_s, NAN), 0.005, 0.0003);
}

/// The velocity beside the position, late by so much; told by the last equation of a channel.
Named found_in_velocity(double late_s) {
  const MadeBench rig;
  const Log log = rig.log([](const Made&) { return 0.0; });
  Log with_velocity;
  with_velocity.train_runs = log.train_runs;
  with_velocity.holdout_runs = log.holdout_runs;
  std::mt19937_64 random(7);
  std::normal_distribution<double> noise(0.0, 0.01);
  for (std::size_t r = 0; r < MadeBench::kRuns; ++r) {
    Run run = log.runs[r];
    for (const double t : run.time_s) {
      run.joints[0][Quantity::kOutputVelocity].push_back(MadeBench::speed_rad_s(r, t - late_s) +
                                                         noise(random));
    }
    with_velocity.runs.push_back(std::move(run));
  }
  return found_in(with_velocity, rig, [](const Bench& bench, const auto& signals, const auto&) {
    return plain_forward(bench, signals).back();
  });
}

TEST(ForwardSearch, CallsASpeedReadWithinItsStepNoMismatch) {
  EXPECT_TRUE(found_in_velocity(0.002).empty());
  auto found = found_in_velocity(0.01);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found["velocity_mismatch"].value("delay_s", NAN), 0.01, 0.0005);
  EXPECT_NEAR(found["velocity_mismatch"].value("scale", NAN), 1.0, 0.002);
}

// A sensor that shows 3 % too much of positive currents, 3 % too little of negative ones.
TEST(ForwardSearch, FindsACurrentsGainThatDiffersBySign) {
  auto found = found_in([](const Made& at) {
    // The log shows the sensor's current; the torque is that of the true one.
    return at.torque_Nm / (1.0 + 0.03 * made::sign(at.current_A)) - at.torque_Nm;
  });
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found["current_gain_error"].value("gain_positive", NAN), 1.03, 0.001);
  EXPECT_NEAR(found["current_gain_error"].value("gain_negative", NAN), 0.97, 0.001);
}

// What both signs have in common is the torque constant.
TEST(ForwardSearch, CallsAGainOfBothSignsTheTorqueConstant) {
  auto found = found_in([](const Made& at) { return 0.05 * at.torque_Nm; });
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found["torque_constant_error"].value("factor", NAN), 1.05, 0.001);
}

// Oracle: the normal distribution's table, and Student's of 30 degrees of freedom (3.646 at 5e-4).
TEST(Comparison, ThresholdIsStudentsWithEveryTrialCounted) {
  EXPECT_NEAR(threshold_t(0.05, 100, 1000000), 3.2905, 1e-3);
  EXPECT_NEAR(threshold_t(0.05, 100, 30), 3.646, 0.02);
}

}  // namespace
}  // namespace torquewright::identification::forward_test
