// SPDX-License-Identifier: Apache-2.0
// Oracle: closed forms. A winding's volts are R i + L di/dt + Ke N w and what a bridge's dead time
// adds along the current; current and speed are sums of sines.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "actuator/effects/library.hpp"
#include "identification/answer/analysis.hpp"
#include "identification/forward/plain_forward.hpp"
#include "identification/forward/winding_current.hpp"
#include "identification/preparation/preparation.hpp"
#include "tests/identification/made_bench.hpp"

namespace torquewright::identification::winding_voltage_test {
namespace {

using made::MadeBench;
using made::sign;

constexpr double kResistance_ohm = 0.5, kDead_V = 0.6, kNoise_V = 0.02, kNoise_A = 0.02;

struct WindingBench : MadeBench {
  WindingBench(double of_winding_H, bool is_declared) : inductance_H(of_winding_H) {
    actuator.motor.torque_constant_convention = actuator::CurrentConvention::kDc;
    actuator.motor.resistance_convention = actuator::ResistanceConvention::kDc;
    actuator.motor.resistance_ohm = kResistance_ohm;
    if (!is_declared) return;
    actuator.effects.push_back(
        {actuator::find_effect("inverter_dead_time"), {kDead_V}, {}, false, "stated"});
  }

  double voltage_V(std::size_t run, double t) const {
    const double current = current_A(run, t), h_s = 1e-5;
    const double rate_A_s = (current_A(run, t + h_s) - current_A(run, t - h_s)) / (2.0 * h_s);
    return kResistance_ohm * current + inductance_H * rate_A_s + kDead_V * sign(current) +
           kTorqueConstant_Nm_A * kRatio * speed_rad_s(run, t);
  }

  Log log(double noise_V, double noise_A, bool has_current = true) const {
    std::mt19937_64 random(11);
    std::normal_distribution<double> noise(0.0, 1.0);
    Log log = MadeBench::log([](const made::Made&) { return 0.0; });
    for (std::size_t r = 0; r < kRuns; ++r) {
      log.runs.change(r, [&](Run& run) {
        auto& joint = run.joints[0];
        for (const double t : run.time_s) {
          joint[Quantity::kWindingVoltage].push_back(voltage_V(r, t) + noise_V * noise(random));
        }
        for (double& each : joint[Quantity::kMotorCurrent]) each += noise_A * noise(random);
        if (!has_current) joint[Quantity::kMotorCurrent].clear();
      });
    }
    return log;
  }

  EquationResult of(const char* quantity, double noise_V, bool has_current) const {
    const Log made = log(noise_V, kNoise_A, has_current);
    for (EquationResult& each : analyse(rig, made, 0, {&actuator}, {})) {
      if (each.quantity == quantity) return std::move(each);
    }
    return {};
  }
  EquationResult of_voltage() const { return of("winding_voltage_V", kNoise_V, true); }

  double inductance_H;
};

/// Mean square of what sampling leaves: a voltage that is sampled jumps in the middle of a sample,
/// the current's sign turns when it does. A step of twice the dead time that is so much late leaves
/// a pulse of the low-pass, whose impulse response has the integral of 1/(1 + (f/cutoff)^4)^2, 3 pi
/// cutoff / (4 sqrt 2), as its own square's.
double square_by_sampling_V2(std::size_t run, double step_s, double end_s, double cutoff_Hz) {
  double late2_s2 = 0.0;
  for (double t = step_s; t < end_s; t += step_s) {
    const double before_A = MadeBench::current_A(run, t - step_s);
    const double after_A = MadeBench::current_A(run, t);
    if (before_A * after_A >= 0.0) continue;
    const double late_s = step_s * (0.5 - before_A / (before_A - after_A));
    late2_s2 += late_s * late_s;
  }
  const double bandwidth_Hz = 0.75 * std::numbers::pi / std::numbers::sqrt2 * cutoff_Hz;
  return 4.0 * kDead_V * kDead_V * late2_s2 * bandwidth_Hz / end_s;
}

TEST(WindingVoltage, HoldsADeclaredDeadTimeAsTheChannelsFilterLeavesIt) {
  const WindingBench made(0.0, true);
  const Log log = made.log(0.0, 0.0);
  const Bench bench = made.bench(log);
  const std::vector<Signals> all = prepare(log, bench, {}, PreparationOptions{});
  const std::vector<ForwardEquation> equations = plain_forward(bench, all);
  ASSERT_EQ(equations.size(), 1u);
  ASSERT_EQ(equations[0].quantity, "winding_voltage_V");
  double square = 0.0, count = 0.0, expected = 0.0;
  for (const Signals& signals : all) {
    const std::vector<double> left_V = equations[0].residual(equations[0].stated, signals);
    for (std::size_t i = 10; i + 10 < left_V.size(); ++i, ++count) square += left_V[i] * left_V[i];
    expected +=
        square_by_sampling_V2(signals.run, 0.005, 12.0, signals.cutoff_Hz) / MadeBench::kRuns;
  }
  EXPECT_NEAR(std::sqrt(square / count), std::sqrt(expected), 0.05 * std::sqrt(expected));
}

TEST(WindingVoltage, IsNotWrongByTheInductanceOfItsWinding) {
  EXPECT_EQ(WindingBench(2e-3, true).of_voltage().verdict, Verdict::kNothingMissing);
}

TEST(WindingVoltage, NamesADeadTimeThatIsNotDeclared) {
  const EquationResult result = WindingBench(2e-3, false).of_voltage();
  ASSERT_EQ(result.added.size(), 1u);
  EXPECT_EQ(result.added[0].effect, "inverter_dead_time");
  EXPECT_NEAR(result.added[0].parameters.value("voltage_V", NAN), kDead_V,
              3.0 * result.added[0].parameters.standard_error("voltage_V"));
}

/// L/R of 2 ms, of which half a step of the log is 2.5.
TEST(WindingVoltage, ThatIsAllThatIsKnownHoldsTheLagOfItsWinding) {
  EXPECT_EQ(WindingBench(1e-3, true).of("output_torque_Nm", 0.1 * kNoise_V, false).verdict,
            Verdict::kNothingMissing);
}

/// Where the voltage alone is logged the current is what leaves the bridge, through the low-pass.
/// Between the signals' samples a cubic stands for what varies slowly, within 1 % of the dead time.
TEST(WindingCurrents, AreTrueBesideReversalsOfTheCurrent) {
  const WindingBench made(0.0, true);
  const Log log = made.log(0.0, 0.0, false);
  const Bench bench = made.bench(log);
  ASSERT_EQ(bench.drive, Drive::kVoltage);
  const std::vector<Signals> all = prepare(log, bench, {}, PreparationOptions{});
  ASSERT_EQ(all.size(), MadeBench::kRuns);
  for (const Signals& signals : all) {
    const Currents currents =
        winding_currents(bench, made.actuator, signals, signals.voltage_V, signals.at, 0.0);
    double worst_A = 0.0;
    for (std::size_t i = 50; i + 50 < signals.size(); ++i) {
      const double true_A = MadeBench::current_A(signals.run, signals.time_s[i]);
      worst_A = std::max(worst_A, std::abs(currents.current_A[i] - true_A));
    }
    EXPECT_LT(worst_A, 0.01 * kDead_V / kResistance_ohm);
  }
}

}  // namespace
}  // namespace torquewright::identification::winding_voltage_test
