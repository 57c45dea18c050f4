// SPDX-License-Identifier: Apache-2.0
#include "hopper/motion/rounding_steps.hpp"

#include <algorithm>
#include <cmath>

#include "hopper/motion/slopes.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kAlike =
    1e-9;  // of the greatest value: differences that rounding of doubles makes
// Of a step: a gap between two values is a number of steps where it is no farther from one. A
// choice of ours.
constexpr double kFits = 0.05;
constexpr Index kFewest = 7;  // samples: of fewer any values may have a common step
// Of the samples beside which the value changes: where more than these bend by half a step, the
// values are rounded to it. A choice of ours.
constexpr double kBends = 0.1;

/// Sorted gaps between values in ascending order that are more than rounding of doubles.
std::vector<double> gaps_of(std::vector<double> values, double least) {
  std::sort(values.begin(), values.end());
  std::vector<double> gaps;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double gap = values[i] - values[i - 1];
    if (gap > least) gaps.push_back(gap);
  }
  std::sort(gaps.begin(), gaps.end());
  return gaps;
}

/// A step that is tried on gaps: itself, made more exact by those that fit, and the least that a
/// gap is off; 0 where all fit.
struct Trial {
  double step = 0.0;
  double left = 0.0;
};

Trial tried(const std::vector<double>& gaps, double step) {
  Trial trial{step, 0.0};
  double product = 0.0;
  double square = 0.0;
  for (const double gap : gaps) {
    const double times = std::max(1.0, std::round(gap / trial.step));
    const double off = std::abs(gap - times * trial.step);
    if (off > kFits * trial.step) {
      trial.left = trial.left == 0.0 ? off : std::min(trial.left, off);
      continue;
    }
    product += gap * times;
    square += times * times;
    trial.step = product / square;
  }
  return trial;
}

/// Whether steps show as bends of the course: what moves evenly over them does not.
bool rounds(const VectorXd& values, double step) {
  Index changing = 0;
  Index bending = 0;
  for (Index i = 1; i + 1 < values.size(); ++i) {
    const double before = values[i] - values[i - 1];
    const double after = values[i + 1] - values[i];
    if (std::max(std::abs(before), std::abs(after)) < 0.5 * step) continue;
    ++changing;
    if (std::abs(after - before) > 0.5 * step) ++bending;
  }
  return static_cast<double>(bending) > kBends * static_cast<double>(changing);
}

double step_of_row(const VectorXd& values) {
  if (values.size() < kFewest) return 0.0;
  const double step = common_step({values.begin(), values.end()});
  return step > 0.0 && rounds(values, step) ? step : 0.0;
}

}  // namespace

double common_step(std::vector<double> values) {
  double greatest = 0.0;
  for (const double value : values) greatest = std::max(greatest, std::abs(value));
  const double least = kAlike * greatest;
  const std::vector<double> gaps = gaps_of(std::move(values), least);
  if (gaps.empty()) return 0.0;
  for (double step = gaps.front(); step > least;) {
    const Trial trial = tried(gaps, step);
    if (trial.left == 0.0) return trial.step;
    step = trial.left;  // Euclid's: a common divisor divides what is left, too
  }
  return 0.0;
}

VectorXd position_steps(const dynamics::Tree& tree, const Motion& motion) {
  VectorXd steps = VectorXd::Zero(tree.velocity_size());
  const bool turns = tree.base == dynamics::BaseKind::kSpatial;
  for (Index row = 0; row < motion.positions.rows(); ++row) {
    const double step = step_of_row(motion.positions.row(row));
    if (!turns || row < 3) {
      steps[row] = step;
    } else if (row < 7) {
      steps.segment<3>(3) = steps.segment<3>(3).cwiseMax(2.0 * step);
    } else {
      steps[row - 1] = step;
    }
  }
  return steps;
}

VectorXd velocity_steps(const Motion& motion) {
  VectorXd steps(motion.velocities.rows());
  for (Index row = 0; row < steps.size(); ++row) {
    steps[row] = step_of_row(motion.velocities.row(row));
  }
  return steps;
}

VectorXd rounding_steps(const dynamics::Tree& tree, const Motion& motion) {
  return has_given_velocity(motion) ? velocity_steps(motion) : position_steps(tree, motion);
}

}  // namespace torquewright::hopper
