// SPDX-License-Identifier: Apache-2.0
#include "actuator/drive_check/winding_heat.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "actuator/effects/library.hpp"

namespace torquewright::actuator {
namespace {

constexpr double kAmbient_K = 300.0;

/// Resistance 0.5 ohm of a phase at the ambient, growing by `coefficient_1_K`.
Actuator heated(double coefficient_1_K) {
  Actuator actuator;
  actuator.motor.torque_constant_Nm_A = 0.1;
  actuator.motor.torque_constant_convention = CurrentConvention::kPeakPhase;
  actuator.motor.resistance_ohm = 0.5;
  actuator.motor.resistance_convention = ResistanceConvention::kPhase;
  actuator.motor.winding_temperature_K = kAmbient_K;
  actuator.drive.bus_voltage_V = 48.0;
  actuator.drive.peak_current_A = 40.0;
  actuator.thermal = Thermal{0.8, 2.0, 30.0, 400.0, 390.0, kAmbient_K};
  actuator.effects.push_back(
      {find_effect("winding_resistance_temperature"), {coefficient_1_K}, {}, false, ""});
  return actuator;
}

/// Warmth of the winding after a time under constant heat, from the ambient: the closed form with
/// two exponentials. x1 solves x1'' + p x1' + q x1 = r, p = trace, q = determinant of the two
/// nodes.
double two_exponentials_K(double heat_W, double time_s) {
  const double R1 = 0.8, R2 = 2.0, C1 = 30.0, C2 = 400.0;
  const double p = 1.0 / (R1 * C1) + 1.0 / (R1 * C2) + 1.0 / (R2 * C2);
  const double q = 1.0 / (R1 * C1 * R2 * C2);
  const double root = std::sqrt(p * p - 4.0 * q);
  const double fast_1_s = 0.5 * (p + root);
  const double slow_1_s = q / fast_1_s;
  const double end_K = heat_W * (R1 + R2);
  // x1 = end + A exp(-fast t) + B exp(-slow t) with x1(0) = 0 and x1'(0) = heat / C1.
  const double A = (heat_W / C1 - slow_1_s * end_K) / (slow_1_s - fast_1_s);
  const double B = -end_K - A;
  return end_K + A * std::exp(-fast_1_s * time_s) + B * std::exp(-slow_1_s * time_s);
}

// Oracle: closed form, the sum of two exponentials; constant resistance, 20 A: 1.5 R i^2 = 300 W.
TEST(WindingHeat, FollowsTwoExponentials) {
  WindingHeat heat(HeatModel(heated(0.0)));
  double time_s = 0.0;
  for (const double step_s : {0.001, 0.5, 3.0, 0.02, 40.0, 200.0, 1000.0}) {
    heat.add(400.0, step_s);
    time_s += step_s;
    const double expected_K = two_exponentials_K(300.0, time_s);
    EXPECT_NEAR(heat.report(1, 0.0).end_K - kAmbient_K, expected_K, 1e-10 * (1.0 + expected_K));
  }
}

/// One second by classical Runge-Kutta on the same two equations, written out again.
Warmth after_a_second(Warmth x, double coefficient_1_K, double square_A2) {
  constexpr int kSteps = 1000;
  constexpr double h = 1.0 / kSteps;
  const auto rate = [&](const Warmth& at) {
    const double loss_W = 1.5 * square_A2 * 0.5 * (1.0 + coefficient_1_K * at[0]);
    const double to_case_W = (at[0] - at[1]) / 0.8;
    return Warmth{(loss_W - to_case_W) / 30.0, (to_case_W - at[1] / 2.0) / 400.0};
  };
  const auto moved = [](const Warmth& from, double step, const Warmth& v) {
    return Warmth{from[0] + step * v[0], from[1] + step * v[1]};
  };
  for (int i = 0; i < kSteps; ++i) {
    const Warmth a = rate(x);
    const Warmth b = rate(moved(x, 0.5 * h, a));
    const Warmth c = rate(moved(x, 0.5 * h, b));
    const Warmth d = rate(moved(x, h, c));
    for (std::size_t k = 0; k < 2; ++k) x[k] += h / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]);
  }
  return x;
}

// Oracle: an independent method, Runge-Kutta (1000 steps a second: its error, of order h^4, is far
// below the tolerance). Copper's coefficient; another current every second.
TEST(WindingHeat, FollowsTheResistanceAsItWarms) {
  constexpr double kCopper_1_K = 0.0039;
  WindingHeat heat(HeatModel(heated(kCopper_1_K)));
  Warmth expected{0.0, 0.0};
  for (int second = 0; second < 100; ++second) {
    const double square_A2 = 300.0 + 200.0 * std::cos(second);
    heat.add(square_A2, 1.0);
    expected = after_a_second(expected, kCopper_1_K, square_A2);
  }
  EXPECT_NEAR(heat.report(1, 0.0).end_K - kAmbient_K, expected[0], 1e-8);
}

// Oracle: the same runs one after the other, as one long run.
TEST(WindingHeat, RepeatsRunsAsIfTheyWereOne) {
  const HeatModel model(heated(0.0039));
  const auto add_run = [](WindingHeat& heat) {
    heat.add(900.0, 0.7);
    heat.add(50.0, 1.3);
  };
  WindingHeat once(model);
  add_run(once);
  WindingHeat often(model);
  for (int i = 0; i < 37; ++i) {
    add_run(often);
    if (i < 36) often.add(0.0, 5.0);
  }
  const WindingReport repeated = once.report(37, 5.0);
  const WindingReport whole = often.report(1, 0.0);
  EXPECT_NEAR(repeated.end_K, whole.end_K, 1e-9);
  EXPECT_NEAR(repeated.peak_K, whole.peak_K, 1e-9);
  EXPECT_LT(repeated.first_peak_K, repeated.peak_K);
}

// Oracle: limits. After very many runs the peak is the steady one; runs_to_steady and runs_to_limit
// are the first that satisfy their definitions.
TEST(WindingHeat, CountsRunsToSteadyAndToTheLimit) {
  WindingHeat heat(HeatModel(heated(0.0039)));
  heat.add(120.0, 2.0);
  heat.add(0.0, 1.0);
  const WindingReport report = heat.report(1, 0.0);
  ASSERT_TRUE(report.steady_peak_K && report.runs_to_steady && report.runs_to_limit);
  EXPECT_NEAR(heat.report(1000000, 0.0).peak_K, *report.steady_peak_K, 1e-8);
  const auto peak_K = [&](std::size_t runs) { return heat.report(runs, 0.0).peak_K; };
  EXPECT_GE(peak_K(*report.runs_to_steady), *report.steady_peak_K - kSteady_K);
  EXPECT_LT(peak_K(*report.runs_to_steady - 1), *report.steady_peak_K - kSteady_K);
  EXPECT_GT(peak_K(*report.runs_to_limit), 390.0);
  EXPECT_LE(peak_K(*report.runs_to_limit - 1), 390.0);
}

// Oracle: closed form. 150 W for many time constants warm the winding by 150 W (R1 + R2) = 420 K,
// far past the limit: within the first run, and no later run is warmer.
TEST(WindingHeat, MayDoAllInItsFirstRun) {
  WindingHeat heat(HeatModel(heated(0.0)));
  heat.add(200.0, 1e5);
  const WindingReport report = heat.report(1, 0.0);
  EXPECT_NEAR(*report.steady_peak_K, kAmbient_K + 420.0, 1e-6);
  EXPECT_EQ(report.runs_to_steady, 1u);
  EXPECT_EQ(report.runs_to_limit, 1u);
}

// Oracle: the same closed form. 15 W warm it by 42 K at most, 90 K are allowed.
TEST(WindingHeat, NeverReachesALimitBeyondItsSteadyState) {
  WindingHeat heat(HeatModel(heated(0.0)));
  heat.add(20.0, 10.0);
  const WindingReport report = heat.report(1, 0.0);
  EXPECT_NEAR(*report.steady_peak_K, kAmbient_K + 42.0, 1e-6);
  EXPECT_FALSE(report.runs_to_limit.has_value());
}

// Oracle: closed form of the threshold. Under constant current the warmth settles just while the
// loss grows slower than the heat flows off: 1.5 i^2 R alpha < 1 / (R1 + R2).
TEST(WindingHeat, KnowsThermalRunaway) {
  const double threshold_A2 = 1.0 / (1.5 * 0.5 * 0.0039 * 2.8);
  for (const double factor : {0.99, 1.01}) {
    WindingHeat heat(HeatModel(heated(0.0039)));
    heat.add(factor * threshold_A2, 10.0);
    const WindingReport report = heat.report(3, 0.0);
    EXPECT_EQ(report.steady_peak_K.has_value(), factor < 1.0);
    EXPECT_TRUE(report.runs_to_limit.has_value());
  }
}

// Oracle: with more current the winding gets no cooler.
TEST(WindingHeat, BeyondAllNumbersIsWithoutBoundFromTheFirstRunOn) {
  for (const double current_A : {1e4, 1e6, 1e8, 1e30, 1e150}) {
    WindingHeat heat(HeatModel(heated(0.004)));
    for (int i = 0; i < 200; ++i) heat.add(current_A * current_A, 1.0);
    for (const std::size_t runs : {1, 2, 1000}) {
      const WindingReport report = heat.report(runs, 0.0);
      EXPECT_EQ(report.first_peak_K, HUGE_VAL) << current_A;
      EXPECT_EQ(report.peak_K, HUGE_VAL) << current_A;
      EXPECT_EQ(report.end_K, HUGE_VAL) << current_A;
      EXPECT_EQ(report.runs_to_limit, 1u) << current_A;
    }
  }
}

// Oracle: the same samples below the number of blocks, where every one is looked at.
TEST(WindingHeat, JoinsNeighboursWithoutChangingTheEnd) {
  const HeatModel model(heated(0.0039));
  WindingHeat fine(model);
  WindingHeat coarse(model);
  for (int i = 0; i < 100000; ++i) fine.add(200.0 + i % 7, 0.001);
  HeatStep all;
  for (int i = 0; i < 100000; ++i) all = then(all, model.step(200.0 + i % 7, 0.001));
  const WindingReport report = fine.report(1, 0.0);
  EXPECT_NEAR(report.end_K - kAmbient_K, all.after({0.0, 0.0})[0], 1e-9);
  EXPECT_NEAR(report.resolution_s, 0.016, 1e-12);
  coarse.add(200.0, 0.5);
  EXPECT_EQ(coarse.report(1, 0.0).resolution_s, 0.0);
}

}  // namespace
}  // namespace torquewright::actuator
