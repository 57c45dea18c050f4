// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/run_results.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "optimization/fit/quantile.hpp"

namespace torquewright::identification {
namespace {

constexpr std::size_t kShares = 300;  ///< Of a curve: a picture has not many more points across.
constexpr double kGap = 1.5;          ///< Usual steps between rows beyond which a line ends.

/// Where the values of one run stand among the rows.
struct RunRows {
  RunResult result;
  std::vector<Eigen::Index> rows;
  std::vector<double> time_s;
};

void append(Curve& curve, double time_s, double value) {
  curve.time_s.push_back(time_s);
  curve.value.push_back(value);
}

std::vector<double> times_of(const Rows& rows) {
  std::vector<double> times;
  for (std::size_t s = 0; s < rows.signals().size(); ++s) {
    for (const std::size_t sample : rows.samples()[s])
      times.push_back(rows.signals()[s].time_s[sample]);
  }
  return times;
}

const Signals& stretch_of_run(const Rows& rows, std::size_t run) {
  return *std::find_if(rows.signals().begin(), rows.signals().end(),
                       [&](const Signals& each) { return each.run == run; });
}

/// Runs of several stretches have one name.
std::vector<RunRows> rows_by_run(const Rows& rows) {
  const std::vector<double> times = times_of(rows);
  std::vector<RunRows> runs;
  for (const Rows::Block& block : rows.blocks()) {
    const Signals& stretch = stretch_of_run(rows, block.run);
    const bool is_held_out = block.is_held_out();
    auto own = std::find_if(runs.begin(), runs.end(), [&](const RunRows& each) {
      return each.result.run == stretch.run_name && each.result.is_held_out == is_held_out;
    });
    if (own == runs.end()) {
      runs.emplace_back();
      own = std::prev(runs.end());
      own->result.run = stretch.run_name;
      own->result.is_map = stretch.step_s == 0.0;
      own->result.is_held_out = is_held_out;
    }
    for (Eigen::Index row = block.begin; row < block.begin + block.count; ++row) {
      own->rows.push_back(row);
      own->time_s.push_back(times[static_cast<std::size_t>(row)]);
    }
  }
  return runs;
}

double usual_step(const std::vector<double>& times) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(times[i] - times[i - 1]);
  return steps.empty() ? 0.0 : optimization::median(std::move(steps));
}

Curve curve_of(const RunRows& run, const Eigen::VectorXd& values) {
  const double most = kGap * usual_step(run.time_s);
  Curve curve;
  for (std::size_t i = 0; i < run.rows.size(); ++i) {
    const double here = run.time_s[i], before = i > 0 ? run.time_s[i - 1] : here;
    const bool is_cut = here < before || here - before > most;
    if (i > 0 && is_cut) append(curve, before, std::numeric_limits<double>::quiet_NaN());
    append(curve, here, values[run.rows[i]]);
  }
  return thinned(curve, kShares);
}

double rms_of(const RunRows& run, const Eigen::VectorXd& values) {
  double square = 0.0;
  for (const Eigen::Index row : run.rows) square += values[row] * values[row];
  return run.rows.empty() ? 0.0 : std::sqrt(square / static_cast<double>(run.rows.size()));
}

}  // namespace

Curve thinned(const Curve& curve, std::size_t shares) {
  const std::size_t n = curve.value.size();
  if (n <= 2 * shares) return curve;
  Curve few;
  for (std::size_t share = 0; share < shares; ++share) {
    std::size_t least = n, greatest = n, gap = n;
    for (std::size_t i = share * n / shares; i < (share + 1) * n / shares; ++i) {
      if (std::isnan(curve.value[i])) gap = i;
      if (std::isnan(curve.value[i])) continue;
      if (least == n || curve.value[i] < curve.value[least]) least = i;
      if (greatest == n || curve.value[i] > curve.value[greatest]) greatest = i;
    }
    std::vector<std::size_t> kept = {least, greatest, gap};
    std::sort(kept.begin(), kept.end());
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
    for (const std::size_t i : kept) {
      if (i < n) append(few, curve.time_s[i], curve.value[i]);
    }
  }
  return few;
}

std::vector<RunResult> run_results(const ForwardEquation& equation, const Rows& rows,
                                   const Eigen::VectorXd& before, const Eigen::VectorXd& after) {
  // docs/derivations/identification.md eq. (4): the residual is measured less predicted, or, where
  // the drive's channel is what was measured, predicted less measured.
  const double unit = std::abs(equation.unit_per_residual);
  const double sign = equation.target_is_drive ? -unit : unit;
  const Eigen::VectorXd measured = rows.values(equation.measured);
  const Eigen::VectorXd stated = measured - sign * before, refined = measured - sign * after;
  std::vector<RunResult> results;
  for (RunRows& run : rows_by_run(rows)) {
    run.result.rms_before = unit * rms_of(run, before);
    run.result.rms_after = unit * rms_of(run, after);
    run.result.measured = curve_of(run, measured);
    run.result.stated = curve_of(run, stated);
    run.result.refined = curve_of(run, refined);
    run.result.left_before = curve_of(run, sign * before);
    run.result.left_after = curve_of(run, sign * after);
    results.push_back(std::move(run.result));
  }
  return results;
}

}  // namespace torquewright::identification
