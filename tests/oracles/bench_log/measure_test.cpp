// SPDX-License-Identifier: Apache-2.0
// Sensors, noise and the residuals that effects are scaled by.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/oracles/bench_log/band.hpp"
#include "tests/oracles/bench_log/bench_draw.hpp"

namespace torquewright::oracles {
namespace {

using Type = Load::Type;

Bench small_bench(Type rig, std::uint64_t seed) {
  Chance chance(seed);
  Wishes wishes;
  wishes.rig = rig;
  wishes.runs = 2;
  wishes.run_s = 10.0;
  wishes.declares_friction = true;
  wishes.velocity = true;
  wishes.voltages = rig == Type::kDynamometer;
  return draw_bench(wishes, chance);
}

std::vector<CleanRun> clean_runs(const Bench& bench) {
  std::vector<CleanRun> runs;
  for (const RunPlan& plan : bench.runs)
    runs.push_back(measure(bench, simulate(bench.truth, plan)));
  return runs;
}

std::size_t column_of(const Bench& bench, const std::string& quantity) {
  for (std::size_t c = 0; c < bench.channels.size(); ++c) {
    if (bench.channels[c].quantity == quantity) return c;
  }
  throw std::invalid_argument(quantity);
}

TEST(Residual, OfATrueModelIsFarBelowTheNoise) {
  // Oracle: the same equations, solved by the simulation and inverted here.
  for (const Type rig : {Type::kDynamometer, Type::kPendulum, Type::kFree, Type::kLinearAxis}) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const Bench bench = small_bench(rig, seed);
      const auto runs = clean_runs(bench);
      for (const auto& [equation, floor] : noise_floors(bench)) {
        EXPECT_LT(residual_rms(runs, equation, sample_rate_Hz(bench)), 0.1 * floor)
            << equation << " of rig " << static_cast<int>(rig);
      }
    }
  }
}

TEST(Residual, OfAnOffsetIsTheOffset) {
  Bench bench = small_bench(Type::kDynamometer, 1);
  bench.faults.torque_offset = 0.25;
  EXPECT_NEAR(residual_rms(clean_runs(bench), "torque", 500.0), 0.25, 1e-9);
}

TEST(Residual, OfACurrentOffsetIsItsTorque) {
  Bench bench = small_bench(Type::kDynamometer, 1);
  bench.faults.current_offset_A = 0.1;
  const double torque = 0.1 * bench.nominal.ratio * bench.nominal.torque_constant_Nm_A;
  EXPECT_NEAR(residual_rms(clean_runs(bench), "torque", 500.0), torque, 1e-9);
}

TEST(Residual, OfUndeclaredCoulombFrictionIsItsLevel) {
  Bench bench = small_bench(Type::kDynamometer, 4);
  bench.truth.friction.coulomb_positive_Nm += 0.3;
  bench.truth.friction.coulomb_negative_Nm += 0.3;
  const CleanRun run = clean_runs(bench)[0];
  for (const double value : run.torque_residual) {
    if (value != 0.0) {
      ASSERT_NEAR(std::abs(value), 0.3, 1e-9);
    }
  }
}

TEST(Delay, ShiftsOneChannelAndNoOther) {
  const Bench plain = small_bench(Type::kDynamometer, 2);
  Bench late = plain;
  late.faults.late_channel = "output_torque_Nm";
  late.faults.late_s = 0.006;  // Three samples.
  const CleanRun before = clean_runs(plain)[0];
  const CleanRun after = clean_runs(late)[0];
  for (std::size_t c = 0; c < plain.channels.size(); ++c) {
    const std::size_t shift = plain.channels[c].quantity == "output_torque_Nm" ? 3 : 0;
    for (std::size_t k = 3; k < before.time_s.size(); ++k) {
      ASSERT_NEAR(after.columns[c][k], before.columns[c][k - shift], 1e-9);
    }
  }
}

TEST(Delay, OfAPartOfASampleFollowsASine) {
  Bench bench = small_bench(Type::kDynamometer, 2);
  bench.faults.late_channel = "motor_current_A";
  bench.faults.late_s = 0.0043;
  Chance chance(1);
  bench.runs[0].current_A = sine(chance, bench.runs[0].knot_count(), 3.0);
  const Knots& command = bench.runs[0].current_A;
  const auto current = clean_runs(bench)[0].columns[column_of(bench, "motor_current_A")];
  const double turn = 2.0 * std::numbers::pi * 3.0;
  // The phase from the first two knots; the cubic's error is (w h)^3 of a knot.
  const double phase = std::atan2(command[0] * std::sin(turn * kTick_s),
                                  command[1] - command[0] * std::cos(turn * kTick_s));
  for (std::size_t k = 10; k < current.size(); ++k) {
    const double t = 0.002 * static_cast<double>(k) - 0.0043;
    ASSERT_NEAR(current[k], std::sin(turn * t + phase), 1e-5);
  }
}

TEST(Noise, HasItsSigmaAndItsSteps) {
  Bench bench = small_bench(Type::kDynamometer, 3);
  const CleanRun clean = clean_runs(bench)[0];
  Chance chance(9);
  const LogRun noisy = with_noise(bench, clean, "run", chance);
  const auto n = static_cast<double>(clean.time_s.size());
  for (std::size_t c = 0; c < bench.channels.size(); ++c) {
    const Channel& channel = bench.channels[c];
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t k = 0; k < clean.time_s.size(); ++k) {
      const double logged = noisy.columns[c + 1][k] * channel.column_scale;
      const double error = logged - clean.columns[c][k];
      sum += error;
      squares += error * error;
      if (channel.resolution > 0.0) {
        const double steps = logged / channel.resolution;
        ASSERT_NEAR(steps, std::round(steps), 1e-6 * std::max(1.0, std::abs(steps)));
      }
    }
    const double sigma = std::hypot(channel.sigma, channel.resolution / std::sqrt(12.0));
    // Five standard errors of mean and of standard deviation; 3 % for the rounding's own shape.
    EXPECT_NEAR(sum / n, 0.0, 5.0 * sigma / std::sqrt(n)) << channel.quantity;
    EXPECT_NEAR(std::sqrt(squares / n), sigma, sigma * (5.0 / std::sqrt(2.0 * n) + 0.03))
        << channel.quantity;
  }
}

TEST(Noise, IsWhite) {
  Chance chance(4);
  std::vector<double> noise(40000);
  for (double& value : noise) value = chance.normal();
  double fourth = 0.0;
  double next = 0.0;
  for (std::size_t k = 1; k < noise.size(); ++k) {
    fourth += std::pow(noise[k], 4);
    next += noise[k] * noise[k - 1];
  }
  const auto n = static_cast<double>(noise.size());
  EXPECT_NEAR(fourth / n, 3.0, 5.0 * std::sqrt(96.0 / n));  // The variance of x^4 is 96.
  EXPECT_NEAR(next / n, 0.0, 5.0 / std::sqrt(n));
}

TEST(Band, PassesWhatIsInsideAndTheShareOfWhiteNoise) {
  Chance chance(5);
  std::vector<double> noise(200000);
  for (double& value : noise) value = chance.normal();
  double squares = 0.0;
  for (const double value : in_band(noise, 500.0)) squares += value * value;
  // Two passes of |H|² = 1/(1 + x^4): the integral of 1/(1 + x^4)² is 3 pi / (8 sqrt 2).
  const double width = 3.0 * std::numbers::pi / (8.0 * std::numbers::sqrt2);
  const double expected = std::sqrt(width * 8.0 / 250.0);
  const double independent = 2.0 * width * 8.0 / 500.0 * 200000.0;
  EXPECT_NEAR(std::sqrt(squares / 200000.0), expected, 5.0 * expected / std::sqrt(independent));
  const Knots slow = sine(chance, 5000, 2.0);
  const Knots low = in_band(slow, 1000.0);
  for (std::size_t k = 1000; k < 4000; ++k) {
    // Twice through: 1/(1 + (2/8)^4), nothing late.
    ASSERT_NEAR(low[k], slow[k] / (1.0 + 1.0 / 256.0), 1e-4);
  }
}

TEST(NoiseFloor, OfADynamometerWithoutMotionNoiseIsThatOfItsTwoSensors) {
  Bench bench = small_bench(Type::kDynamometer, 3);
  for (Channel& channel : bench.channels) {
    channel.sigma = channel.resolution = 0.0;
    if (channel.quantity == "output_torque_Nm") channel.sigma = 0.3;
  }
  EXPECT_NEAR(noise_floors(bench).at("torque"), 0.3 * std::sqrt(8.0 / 250.0), 1e-12);
}

}  // namespace
}  // namespace torquewright::oracles
