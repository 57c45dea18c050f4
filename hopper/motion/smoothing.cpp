// SPDX-License-Identifier: Apache-2.0
#include "hopper/motion/smoothing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "hopper/motion/least_doubt.hpp"
#include "hopper/motion/slopes.hpp"
#include "optimization/fit/quantile.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Index kSeven = 7;  // samples: what no polynomial of the fifth degree explains is noise
/// So many of normal numbers lie within so many standard deviations.
struct NormalShare {
  double share;
  double deviations;
};
constexpr NormalShare kHalf{0.5, 0.6745};
constexpr NormalShare kMost{0.95, 1.96};
constexpr double kNinetyOfNormal = 1.6449;  // nine of ten lie within
constexpr double kBiasBeside = 1.4142;      // a bias as large as the noise widens it so
constexpr double kNegligible = 1e-3;  // share of the accelerations: less noise is left as it is
// Samples, evenly over the motion, at which reaches are compared: each costs an acceleration by
// every reach, and a median of so many is known to 4 % of a deviation.
constexpr Index kMostSamples = 1000;
constexpr std::array<Index, 5> kReaches{1, 2, 4, 8, 16};

VectorXd differentiated(const dynamics::Tree& tree, const Motion& motion, Index from, Index to) {
  if (has_given_velocity(motion)) return motion.velocities.col(to) - motion.velocities.col(from);
  return displacement(tree, motion.positions.col(from), motion.positions.col(to));
}

/// No break, and no two rows of one time, among the samples [first, last].
bool is_whole(const Motion& motion, Index first, Index last) {
  if (first < 0 || last >= motion.samples()) return false;
  const auto after = std::upper_bound(motion.breaks.begin(), motion.breaks.end(), first);
  return after == motion.breaks.end() || *after > last;
}

/// How the seventh of samples counts beside the other six in what the polynomial through these
/// misses, scaled so that noise keeps its standard deviation.
VectorXd seven_counts(const Motion& motion, Index first) {
  VectorXd counts(kSeven);
  const double step_s = (motion.time_s(first + kSeven - 1) - motion.time_s(first)) / (kSeven - 1);
  for (Index i = 0; i < kSeven; ++i) {
    double product = 1.0;
    for (Index j = 0; j < kSeven; ++j) {
      if (j != i) product *= (motion.time_s(first + i) - motion.time_s(first + j)) / step_s;
    }
    counts[i] = 1.0 / product;
  }
  return counts.normalized();
}

/// Standard deviation by row; `difference(a, b)` leads from sample a to sample b.
template <typename Difference>
VectorXd noise_by(const Motion& motion, Index rows, const NormalShare& share,
                  const Difference& difference) {
  std::vector<std::vector<double>> sizes(static_cast<std::size_t>(rows));
  for (Index first = 0; first + kSeven <= motion.samples(); ++first) {
    if (!is_whole(motion, first, first + kSeven - 1)) continue;
    const VectorXd counts = seven_counts(motion, first);
    VectorXd missed = VectorXd::Zero(rows);
    for (Index i = 0; i < kSeven; ++i) {
      missed += counts[i] * difference(first + kSeven / 2, first + i);
    }
    for (Index row = 0; row < rows; ++row) {
      sizes[static_cast<std::size_t>(row)].push_back(std::abs(missed[row]));
    }
  }
  VectorXd noise = VectorXd::Zero(rows);
  for (Index row = 0; row < rows; ++row) {
    auto& of_row = sizes[static_cast<std::size_t>(row)];
    if (of_row.empty()) continue;
    noise[row] = optimization::lower_quantile(std::move(of_row), share.share) / share.deviations;
  }
  return noise;
}

/// Accelerations of some samples at every reach, (reaches) by sample.
struct SmoothingTrial {
  std::vector<std::array<FittedAcceleration, kReaches.size()>> samples;
};

SmoothingTrial trial_of(const dynamics::Tree& tree, const Motion& motion) {
  SmoothingTrial trial;
  const Index most = kReaches.back();
  const Index stride = std::max<Index>(1, motion.samples() / kMostSamples);
  for (Index sample = most; sample < motion.samples() - most; sample += stride) {
    if (!is_whole(motion, sample - most, sample + most)) continue;
    auto& found = trial.samples.emplace_back();
    for (std::size_t i = 0; i < kReaches.size(); ++i) {
      found[i] = fitted_acceleration(tree, motion, sample, kReaches[i]);
    }
  }
  return trial;
}

/// Of the coordinate in which it is the most: noise over rms of the accelerations at that reach.
double noise_share(const SmoothingTrial& trial, const VectorXd& noise, std::size_t reach) {
  VectorXd square = VectorXd::Zero(noise.size());
  double gain = 0.0;
  for (const auto& sample : trial.samples) {
    square += sample[reach].acceleration.cwiseAbs2();
    gain += sample[reach].gain;
  }
  const auto count = static_cast<double>(trial.samples.size());
  const VectorXd rms = (square / count).cwiseSqrt();
  double share = 0.0;
  for (Index row = 0; row < noise.size(); ++row) {
    if (rms[row] > 0.0) share = std::max(share, noise[row] * gain / count / rms[row]);
  }
  return share;
}

/// Whether the wider reach changes no more than noise explains. Of least squares over windows that
/// lie in each other, the variance of the difference is the difference of variances.
bool explains(const SmoothingTrial& trial, const VectorXd& noise, std::size_t narrow,
              std::size_t wide) {
  std::vector<double> changes;
  for (const auto& sample : trial.samples) {
    const double gain = std::sqrt(sample[narrow].gain * sample[narrow].gain -
                                  sample[wide].gain * sample[wide].gain);
    for (Index row = 0; row < noise.size(); ++row) {
      if (noise[row] == 0.0) continue;
      const double change =
          std::abs(sample[narrow].acceleration[row] - sample[wide].acceleration[row]);
      changes.push_back(change / (noise[row] * gain));
    }
  }
  return !changes.empty() &&
         optimization::lower_quantile(std::move(changes), 0.9) <= kNinetyOfNormal * kBiasBeside;
}

/// Index of the reach.
std::size_t widest(const SmoothingTrial& trial, const VectorXd& noise) {
  std::size_t chosen = 0;
  while (chosen + 1 < kReaches.size() && noise_share(trial, noise, chosen) > kNegligible) {
    for (std::size_t narrow = 0; narrow <= chosen; ++narrow) {
      if (!explains(trial, noise, narrow, chosen + 1)) return chosen;
    }
    ++chosen;
  }
  return chosen;
}

/// Whether steps may make more than a negligible part of accelerations that look at neighbours
/// alone.
bool is_rounded(const dynamics::Tree& tree, const Motion& motion) {
  const bool has_steps = motion.steps.size() > 0 && !motion.steps.isZero(0.0);
  if (!has_steps || motion.acceleration_origin == Origin::kGiven) return false;
  Motion narrow = motion;
  derive_rates(tree, narrow, 1);
  const double most = amplification(motion, 1).most.maxCoeff();
  for (Index row = 0; row < motion.steps.size(); ++row) {
    const double rms =
        narrow.accelerations.row(row).norm() / std::sqrt(static_cast<double>(motion.samples()));
    if (0.5 * motion.steps[row] * most > kNegligible * rms) return true;
  }
  return false;
}

}  // namespace

VectorXd noise_of_differentiated(const dynamics::Tree& tree, const Motion& motion) {
  return noise_by(motion, tree.velocity_size(), kHalf, [&](Index middle, Index other) {
    return differentiated(tree, motion, middle, other);
  });
}

VectorXd sample_noise(const Motion& motion, const Eigen::MatrixXd& table) {
  return noise_by(motion, table.rows(), kMost, [&](Index middle, Index other) -> VectorXd {
    return table.col(other) - table.col(middle);
  });
}

Smoothing smoothing_of(const dynamics::Tree& tree, const Motion& motion) {
  const SmoothingTrial trial = trial_of(tree, motion);
  const VectorXd noise = noise_of_differentiated(tree, motion);
  if (is_rounded(tree, motion)) return smoothing_of_least_doubt(tree, motion, noise);
  if (trial.samples.empty()) return {};
  const std::size_t chosen = widest(trial, noise);
  if (chosen + 1 == kReaches.size() && noise_share(trial, noise, chosen) > kNegligible) {
    Motion without_steps = motion;
    without_steps.steps.setZero(noise.size());
    return smoothing_of_least_doubt(tree, without_steps, noise);
  }
  return {kReaches[chosen], noise * trial.samples.front()[chosen].gain};
}

}  // namespace torquewright::hopper
