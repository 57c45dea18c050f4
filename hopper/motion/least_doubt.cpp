// SPDX-License-Identifier: Apache-2.0
#include "hopper/motion/least_doubt.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hopper/motion/slopes.hpp"
#include "optimization/fit/quantile.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kDeviations = 4.0;
constexpr double kMost = 0.95;      // share of the samples by whose doubt a window is judged
constexpr double kClearly = 4.0;    // times the least doubt: wider windows know no better
constexpr Index kWidest = 1 << 13;  // neighbours on either side: windows double, so 13 of them
const double kRoundingOfUniform = 1.0 / std::sqrt(12.0);  // standard deviation, of a step

/// One window: its accelerations, and what steps and noise may make of them, (n x samples).
struct Level {
  Index reach = 1;
  MatrixXd accelerations;
  MatrixXd rounding;
};

/// What is left of the noise found once rounding has explained its own.
VectorXd noise_beside(const VectorXd& steps, const VectorXd& noise) {
  const VectorXd rounding = kRoundingOfUniform * steps;
  return (noise.cwiseAbs2() - rounding.cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
}

Level level_of(const dynamics::Tree& tree, const Motion& motion, const VectorXd& noise,
               Index reach) {
  Motion tried = motion;
  derive_rates(tree, tried, reach);
  const Amplification gains = amplification(motion, reach);
  return {reach, std::move(tried.accelerations),
          0.5 * motion.steps * gains.most.transpose() +
              kDeviations * noise_beside(motion.steps, noise) * gains.noise.transpose()};
}

/// What the narrower windows show that the last one hides, as far as they leave it open.
MatrixXd hidden(const std::vector<Level>& levels, std::size_t chosen) {
  const Level& own = levels[chosen];
  MatrixXd most = MatrixXd::Zero(own.accelerations.rows(), own.accelerations.cols());
  for (std::size_t narrow = 0; narrow < chosen; ++narrow) {
    const Level& other = levels[narrow];
    const Level& narrower = levels[narrow > 0 ? narrow - 1 : 0];
    const auto apart = (own.accelerations - other.accelerations).cwiseAbs().array();
    const auto open =
        (own.accelerations - narrower.accelerations).cwiseAbs().array() + narrower.rounding.array();
    most = (apart > own.rounding.array() + other.rounding.array())
               .select(open.max(most.array()), most.array());
  }
  return most;
}

/// Of the worst coordinate what nineteen of twenty samples stay within.
double doubt_of(const MatrixXd& doubts) {
  double worst = 0.0;
  for (Index row = 0; row < doubts.rows(); ++row) {
    const VectorXd values = doubts.row(row);
    worst = std::max(worst, optimization::lower_quantile({values.begin(), values.end()}, kMost));
  }
  return worst;
}

}  // namespace

Smoothing smoothing_of_least_doubt(const dynamics::Tree& tree, const Motion& motion,
                                   const VectorXd& noise) {
  std::vector<Level> levels{level_of(tree, motion, noise, 1)};
  Smoothing best{1, levels.front().rounding.rowwise().maxCoeff() / kDeviations,
                 levels.front().rounding};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; 4 * levels[i].reach + 1 < motion.samples(); ++i) {
    if (levels[i].reach > kWidest) break;
    levels.push_back(level_of(tree, motion, noise, 2 * levels[i].reach));
    const MatrixXd known = levels[i].rounding + hidden(levels, i);
    const double doubt =
        doubt_of(known + (levels[i + 1].accelerations - levels[i].accelerations).cwiseAbs());
    if (doubt > kClearly * least) break;
    if (doubt >= least) continue;
    least = doubt;
    best = {levels[i].reach, levels[i].rounding.rowwise().maxCoeff() / kDeviations, known};
  }
  return best;
}

}  // namespace torquewright::hopper
