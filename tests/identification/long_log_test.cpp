// SPDX-License-Identifier: Apache-2.0
// Oracle: the same log, prepared as a whole.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "identification/equation_fit.hpp"
#include "identification/log/stretch.hpp"
#include "identification/signal_source.hpp"
#include "tests/identification/made_bench.hpp"

namespace torquewright::identification::long_log_test {
namespace {

using made::MadeBench;

constexpr std::size_t kPiece = 6000;  ///< A multiple of what 1 kHz is thinned by, 10 times 3.
constexpr std::size_t kSamples = 5 * kPiece + 1800;

/// What the low-pass of 8 Hz still knows of a cut 1.08 s away: exp(-2 pi 8 1.08 / sqrt 2), in each
/// of its two factors, is 2e-17; that of 25 Hz less. What remains is round-off in the times of the
/// grids: 1e-13 of the signals, through a second derivative (thrice a factor of 25 Hz 2 pi).
constexpr double kRoundOff = 1e-7;

/// Presliding friction begins each piece at rest; after a travel s its state errs by exp(-s/length)
/// at most. The longest length is 0.3 of the stroke, 2.7 rad; the mean speed of 2.7 rad/s or more
/// takes e^-1 off in the second before the piece, and the rest within e^-1 times one second of its
/// six.
constexpr double kForgotten = 0.37 / 6.0;

/// Runs of 31.8 s at 1 kHz.
Log whole_log() {
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
      run.joints[0][Quantity::kOutputTorque].push_back(torque - 0.4 * std::tanh(speed / 0.05) -
                                                       0.03 * speed);
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
  Prepared(const Log& log, std::size_t replicas, const NoiseLevels& noise = {})
      : bench(rig.bench(log)), levels(noise), source(log, bench, levels, {}, replicas, 1) {}

  Dictionary dictionary() const { return torque_dictionary(bench, extent(), {}); }

  Gram gram(double block_s = 1.5, bool with_noise = false) const {
    const Dictionary dictionary = this->dictionary();
    const Target target = [this](const Signals& s) { return torque_residual(bench, s); };
    BandOptions band;
    band.block_s = block_s;
    band.most_blocks = static_cast<std::size_t>(source.total_s() / block_s) + 1;
    return build_gram(source, with_noise, dictionary, target, band);
  }
  /// The same for all, whatever rows are held.
  static Extent extent() {
    Extent extent;
    extent.speed_rad_s = 5.0;
    extent.current_A = 9.0;
    extent.output_angle_rad = extent.motor_angle_rad = 9.0;
    return extent;
  }

  MadeBench rig;
  Bench bench;
  NoiseLevels levels;
  SignalSource source;
};

Eigen::MatrixXd sum(const Gram& gram) {
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(gram.noise.rows(), gram.noise.cols());
  for (const Block& block : gram.blocks) all += block.product;
  return all;
}

/// Holds every product against another's, in their columns' own size.
void expect_same_products(const Gram& a, const Gram& b, const Dictionary& dictionary) {
  const Eigen::MatrixXd one = sum(a), other = sum(b);
  const Eigen::VectorXd size = other.diagonal().cwiseSqrt().cwiseMax(1e-12);
  const auto remembers = [&](Eigen::Index c) {
    return c < a.target() && dictionary.columns[static_cast<std::size_t>(c)].name == "presliding";
  };
  for (Eigen::Index r = 0; r < one.rows(); ++r) {
    for (Eigen::Index c = 0; c < one.cols(); ++c) {
      const double difference = std::abs(one(r, c) - other(r, c)) / (size[r] * size[c]);
      EXPECT_LT(difference, remembers(r) || remembers(c) ? kForgotten : kRoundOff) << r << " " << c;
    }
  }
}

TEST(LongLogInPieces, GivesTheProductsOfTheWhole) {
  const Log log = whole_log();
  const Prepared prepared(log, 0);
  const Gram whole = prepared.gram();
  const Gram pieces = Prepared(cut(log, 2 * kPiece), 0).gram();
  EXPECT_EQ(pieces.samples, whole.samples);
  EXPECT_EQ(pieces.is_usable, whole.is_usable);
  expect_same_products(pieces, whole, prepared.dictionary());
}

// Without their neighbours the pieces lose their ends: what the test above would see.
TEST(LongLogInPieces, NeedTheirNeighbours) {
  const Log log = whole_log();
  const Gram whole = Prepared(log, 0).gram();
  const Gram apart = Prepared(cut(log, 2 * kPiece, false), 0).gram();
  EXPECT_LT(apart.samples, 0.95 * whole.samples);
}

// Where blocks are longer than pieces, several pieces share one; none holds samples of two runs.
TEST(LongLogInPieces, ShareBlocksThatAreLonger) {
  const Log log = whole_log();
  const Prepared prepared(log, 0);
  const Gram whole = prepared.gram(15.0);
  const Gram pieces = Prepared(cut(log, 2 * kPiece), 0).gram(15.0);
  EXPECT_EQ(pieces.samples, whole.samples);
  expect_same_products(pieces, whole, prepared.dictionary());
  EXPECT_EQ(whole.blocks.size(), 2 * MadeBench::kRuns);
  EXPECT_LE(pieces.blocks.size(), 3 * MadeBench::kRuns);
  const std::size_t per_run = kSamples / kPiece + 1;
  for (std::size_t r = 0; r < MadeBench::kRuns; ++r) {
    double samples = 0.0, expected = 0.0;
    for (const Block& block : pieces.blocks)
      samples += block.run / per_run == r ? block.samples : 0.0;
    for (const Block& block : whole.blocks) expected += block.run == r ? block.samples : 0.0;
    EXPECT_EQ(samples, expected) << r;
  }
}

// Noise that is added once more has the same power, whoever draws it: of some 1e5 draws through a
// filter that leaves 1e4 degrees of freedom, a percent and a half.
TEST(LongLogInPieces, HasTheNoiseOfTheWhole) {
  NoiseLevels levels{};
  levels[static_cast<std::size_t>(Quantity::kOutputTorque)] = 0.3;
  const Log log = whole_log();
  const Gram whole = Prepared(log, 2, levels).gram(1.5, true);
  const Gram pieces = Prepared(cut(log, 2 * kPiece), 2, levels).gram(1.5, true);
  const double expected = whole.noise(whole.target(), whole.target());
  EXPECT_GT(expected, 0.0);
  EXPECT_NEAR(pieces.noise(pieces.target(), pieces.target()) / expected, 1.0, 0.06);
}

TEST(LongLogInPieces, IsTheSameOnEveryVisit) {
  NoiseLevels levels{};
  levels[static_cast<std::size_t>(Quantity::kOutputTorque)] = 0.3;
  const Log log = cut(whole_log(), 2 * kPiece);
  const Prepared prepared(log, 2, levels);
  const Gram first = prepared.gram(1.5, true), second = prepared.gram(1.5, true);
  EXPECT_EQ(first.noise, second.noise);
  EXPECT_EQ(sum(first), sum(second));
}

TEST(LongLogInPieces, HoldsRowsOfAPartOnly) {
  const Log log = cut(whole_log(), 4 * kPiece);
  const Prepared prepared(log, 0);
  EXPECT_GE(prepared.source.rows().size(), 3u);
  EXPECT_LE(prepared.source.rows().size(), 5u);
  std::size_t stretches = 0;
  prepared.source.visit([&](const Signals&, const auto&) { ++stretches; });
  EXPECT_EQ(stretches, log.runs.size());
  EXPECT_EQ(Prepared(whole_log(), 0).source.rows().size(), MadeBench::kRuns);
}

}  // namespace
}  // namespace torquewright::identification::long_log_test
