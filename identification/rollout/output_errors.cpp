// SPDX-License-Identifier: Apache-2.0
#include "identification/rollout/output_errors.hpp"

#include <algorithm>
#include <cmath>

#include "identification/rollout/rollout.hpp"
#include "identification/rollout/side_by_side.hpp"

namespace torquewright::identification {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kFitStep_s = 2e-3;  ///< Of integration: slopes need no more.
constexpr double kSlopeStep = 0.05;  ///< Of a value's size: events of sticking are averaged.
constexpr double kFitWindow_s = 10.0;
constexpr double kAlike = 0.05;  ///< A correlation that still counts.

/// Samples over which what is left of one joint in one window stays alike: the sum of its
/// correlations, apart from its mean.
double correlated_samples(const VectorXd& whole) {
  const VectorXd left = whole.array() - whole.mean();
  const double square = left.squaredNorm();
  if (!(square > 0.0)) return 1.0;
  double sum = 1.0;
  for (Index lag = 1; lag < left.size() / 4; ++lag) {
    const Index n = left.size() - lag;
    const double correlation = left.head(n).dot(left.tail(n)) / square;
    if (correlation < kAlike) break;
    sum += 2.0 * correlation;
  }
  return sum;
}

}  // namespace

std::vector<Window> fit_windows(const Log& log, double most_s, bool held_out) {
  std::vector<Window> chosen;
  for (const Window& each : windows_of(log, kFitWindow_s)) {
    if (is_held_out(log, log.runs.head(each.run).name) == held_out) chosen.push_back(each);
  }
  return spread(chosen, std::max<std::size_t>(1, static_cast<std::size_t>(most_s / kFitWindow_s)));
}

VectorXd output_errors_rad(const Log& log, const RobotModel& model, const Limb& limb,
                           const std::vector<Window>& windows) {
  std::vector<double> all;
  for (const Window& window : windows) {
    const auto off = limb_errors_rad(model, limb, log.runs[window.run], window, kFitStep_s);
    if (off.empty()) return {};
    for (const std::vector<double>& each : off) all.insert(all.end(), each.begin(), each.end());
  }
  return Eigen::Map<const VectorXd>(all.data(), static_cast<Index>(all.size()));
}

VectorXd slope_of(const Log& log, const RobotModel& model, const FreeValue& which, std::size_t limb,
                  const std::vector<Window>& windows, const VectorXd& errors) {
  const double value = value_in(model, which);
  double step = kSlopeStep * which.size;
  if (value + step > which.highest) step = -step;
  RobotModel moved = model;
  set_value(moved, which, value + step);
  const VectorXd then = output_errors_rad(log, moved, limbs_of(moved.load)[limb], windows);
  if (then.size() == 0) return {};
  return (then - errors) * (which.size / step);
}

MatrixXd slopes_of(const Log& log, const RobotModel& model, const std::vector<FreeValue>& values,
                   std::size_t limb, const std::vector<Window>& windows, const VectorXd& errors) {
  const auto columns = side_by_side<VectorXd>(log, values.size(), [&](std::size_t k) {
    return slope_of(log, model, values[k], limb, windows, errors);
  });
  MatrixXd all(errors.size(), static_cast<Index>(values.size()));
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (columns[k].size() == 0) return {};
    all.col(static_cast<Index>(k)) = columns[k];
  }
  return all;
}

double weight_of(const std::vector<VectorXd>& errors, const std::vector<Limb>& limbs,
                 const std::vector<Window>& windows) {
  double correlated = 0.0, count = 0.0, squares = 0.0, samples_of_all = 0.0;
  for (std::size_t l = 0; l < errors.size(); ++l) {
    Index from = 0;
    squares += errors[l].squaredNorm();
    samples_of_all += static_cast<double>(errors[l].size());
    for (const Window& window : windows) {
      const auto samples = static_cast<Index>(window.last - window.first + 1);
      for (std::size_t joint = 0; joint < limbs[l].joints.size(); ++joint, from += samples) {
        correlated += correlated_samples(errors[l].segment(from, samples));
        ++count;
      }
    }
  }
  if (!(squares > 0.0) || !(count > 0.0)) return 1.0;
  return samples_of_all * count / (squares * correlated);
}

}  // namespace torquewright::identification
