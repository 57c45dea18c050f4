// SPDX-License-Identifier: Apache-2.0
// Oracle: the same log, prepared as a whole.
#include "identification/preparation/held_signals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "actuator/effects/library.hpp"
#include "identification/forward/torque_prediction.hpp"
#include "identification/log/stretch.hpp"
#include "identification/signals/rows.hpp"
#include "tests/identification/made_bench.hpp"

namespace torquewright::identification::held_signals_test {
namespace {

using made::MadeBench;

constexpr std::size_t kPiece = 6000;  ///< A multiple of what 1 kHz is thinned by, 10 times 3.
constexpr std::size_t kSamples = 5 * kPiece + 1800;

/// What the low-pass of 8 Hz still knows of a cut 1.08 s away: exp(-2 pi 8 1.08 / sqrt 2), in each
/// of its two factors, is 2e-17; that of 25 Hz less. What remains is round-off in the times of the
/// grids: 1e-13 of the signals, through a second derivative (thrice a factor of 25 Hz 2 pi).
constexpr double kRoundOff = 1e-7;

constexpr std::size_t kAllRows = 1000000;

/// Torque on the output beside the motor's, sample by sample.
using Friction = std::function<double(double angle_rad, double speed_rad_s)>;
double smooth_friction_Nm(double /*angle_rad*/, double speed_rad_s) {
  return -0.4 * std::tanh(speed_rad_s / 0.05) - 0.03 * speed_rad_s;
}

/// Runs of 31.8 s at 1 kHz.
Log whole_log(const Friction& friction_Nm = smooth_friction_Nm) {
  Log log;
  for (std::size_t r = 0; r < MadeBench::kRuns; ++r) {
    Run run;
    run.name = "run_" + std::to_string(r);
    (r + 1 == MadeBench::kRuns ? log.holdout_runs : log.train_runs).push_back(run.name);
    run.joints.resize(1);
    for (std::size_t k = 0; k < kSamples; ++k) {
      const double t = 0.001 * static_cast<double>(k);
      const double torque =
          MadeBench::kRatio * MadeBench::kTorqueConstant_Nm_A * MadeBench::current_A(r, t);
      const double speed = MadeBench::speed_rad_s(r, t);
      run.time_s.push_back(t);
      run.joints[0][Quantity::kOutputPosition].push_back(MadeBench::angle_rad(r, t));
      run.joints[0][Quantity::kMotorCurrent].push_back(MadeBench::current_A(r, t));
      run.joints[0][Quantity::kOutputTorque].push_back(
          torque + friction_Nm(MadeBench::angle_rad(r, t), speed));
    }
    run.masked.assign(kSamples, 0);
    log.runs.push_back(std::move(run));
  }
  return log;
}

/// The same in pieces, in a file.
Log cut(const Log& whole, std::size_t most_rows, bool continues = true) {
  Log log = whole;
  log.runs = Runs(most_rows);
  for (const Run& run : whole.runs) {
    for (std::size_t begin = 0; begin < kSamples; begin += kPiece) {
      Run piece = part_of(run, begin, std::min(kSamples, begin + kPiece));
      piece.continues = continues && begin > 0;
      log.runs.push_back(std::move(piece));
    }
  }
  return log;
}

struct Prepared {
  Prepared(const Log& log, const NoiseLevels& levels = {})
      : bench(rig.bench(log)), held(held_signals(log, bench, levels, 1)) {}

  /// Of the forward balance as stated, over all that is held; and of what noise added changes.
  double square() const {
    return square_of([](double own, double) { return own; });
  }
  double added_square() const {
    return square_of([](double own, double noisy) { return noisy - own; });
  }
  template <typename Value>
  double square_of(const Value& value) const {
    const Hypothesis stated{bench.actuator(), *bench.rig, {}};
    double sum = 0.0;
    for (std::size_t s = 0; s < held.rows.size(); ++s) {
      const Signals& each = held.rows[s];
      const std::vector<double> own = torque_balance_Nm(bench, stated, each);
      const std::vector<double> noisy = torque_balance_Nm(bench, stated, held.replica[s]);
      for (std::size_t i = each.core_begin; i < std::min(each.core_end, each.size()); ++i) {
        sum += value(own[i], noisy[i]) * value(own[i], noisy[i]);
      }
    }
    return sum;
  }
  std::size_t samples() const {
    std::size_t sum = 0;
    for (const Signals& each : held.rows) sum += each.core_size();
    return sum;
  }

  MadeBench rig;
  Bench bench;
  HeldSignals held;
};

TEST(HeldSignals, GivesTheSignalsOfTheWhole) {
  const Log log = whole_log();
  const Prepared whole(log), pieces(cut(log, kAllRows));
  EXPECT_EQ(pieces.samples(), whole.samples());
  const double expected = whole.square();
  EXPECT_GT(expected, 0.0);
  EXPECT_NEAR(pieces.square() / expected, 1.0, kRoundOff);
}

// Noise that is added once more has the same power, whoever draws it: of some 1e5 draws through a
// filter that leaves 1e4 degrees of freedom, a percent and a half.
TEST(HeldSignals, HasTheNoiseOfTheWhole) {
  NoiseLevels levels{};
  levels[static_cast<std::size_t>(Quantity::kOutputTorque)] = 0.3;
  const Log log = whole_log();
  const double expected = Prepared(log, levels).added_square();
  EXPECT_GT(expected, 0.0);
  EXPECT_NEAR(Prepared(cut(log, kAllRows), levels).added_square() / expected, 1.0, 0.06);
}

TEST(HeldSignals, HoldsRowsOfAPartOnly) {
  const Prepared prepared(cut(whole_log(), 4 * kPiece));
  EXPECT_GE(prepared.held.rows.size(), 3u);
  EXPECT_LE(prepared.held.rows.size(), 5u);
  EXPECT_EQ(Prepared(whole_log()).held.rows.size(), MadeBench::kRuns);
}

constexpr double kFriction_Nm = 0.4, kStep_s = 0.001, kBand_Hz = 24.0;

/// Mean square, in a band, of what the balance leaves of a log whose friction is stated.
double square_left(const Friction& friction_Nm, const actuator::Effect& stated) {
  Prepared log(whole_log(friction_Nm));
  log.rig.actuator.effects = {stated};
  const Rows rows(log.held.rows, {0, 0, 0, 0}, {kBand_Hz});
  const Eigen::VectorXd left = rows.values([&](const Signals& signals) {
    return torque_balance_Nm(log.bench, {log.rig.actuator, log.rig.rig, {}}, signals);
  });
  return left.squaredNorm() / static_cast<double>(left.size());
}

/// What comes of it where samples know each reversal to half a step h: that leaves the area c h of
/// a friction c, of which a filter 1/(1 + (f/fc)^4) makes the square 2 fc pi 3/(8 sqrt 2), by its
/// integral over frequency; the signals' own filter makes it no more.
double square_of_half_steps() {
  double reversals = 0.0, duration_s = 0.0;
  for (std::size_t r = 0; r < MadeBench::kRuns; ++r) {
    for (std::size_t k = 1; k < kSamples; ++k) {
      const double t = kStep_s * static_cast<double>(k);
      reversals += MadeBench::speed_rad_s(r, t) * MadeBench::speed_rad_s(r, t - kStep_s) < 0.0;
    }
    duration_s += kStep_s * static_cast<double>(kSamples);
  }
  const double of_an_impulse_Hz =
      2.0 * kBand_Hz * std::numbers::pi * 3.0 / (8.0 * std::numbers::sqrt2);
  return std::pow(kFriction_Nm * kStep_s, 2) * of_an_impulse_Hz * reversals / duration_s;
}

// A sensor shows a friction's step as the filters pass it; the prediction must go through the same.
// Oracle: the closed form of what the samples leave open.
TEST(HeldSignals, HoldTheBalanceThroughReversals) {
  const auto friction_Nm = [](double, double speed_rad_s) {
    return speed_rad_s > 0.0 ? -kFriction_Nm : kFriction_Nm;
  };
  EXPECT_LT(square_left(friction_Nm,
                        {actuator::find_effect("coulomb_friction"), {kFriction_Nm}, {}, false, ""}),
            square_of_half_steps());
}

// Friction that first gives way, by Dahl's law over each sample's way: of 1 mrad it is a step for
// the filters, whose place the angle says.
TEST(HeldSignals, HoldTheBalanceThroughPresliding) {
  constexpr double kStiffness_Nm_rad = 400.0;
  double level_Nm = 0.0, last_rad = 0.0;
  const auto friction_Nm = [&](double angle_rad, double) {
    const double end_Nm = angle_rad > last_rad ? kFriction_Nm : -kFriction_Nm;
    const double way_rad = std::abs(angle_rad - last_rad);
    level_Nm = end_Nm + (level_Nm - end_Nm) * std::exp(-kStiffness_Nm_rad / kFriction_Nm * way_rad);
    last_rad = angle_rad;
    return -level_Nm;
  };
  EXPECT_LT(square_left(friction_Nm, {actuator::find_effect("presliding_friction"),
                                      {kFriction_Nm, kStiffness_Nm_rad},
                                      {},
                                      false,
                                      ""}),
            square_of_half_steps());
}

}  // namespace
}  // namespace torquewright::identification::held_signals_test
