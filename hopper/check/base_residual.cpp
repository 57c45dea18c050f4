// SPDX-License-Identifier: Apache-2.0
#include "hopper/check/base_residual.hpp"

#include <algorithm>

#include "hopper/check/running_integral.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

constexpr double kNoise = 4.0;  // standard deviations

void note(const Eigen::VectorXd& mean, Index first, Index count, double time_s,
          ResidualPeak& peak) {
  if (count == 0) return;
  const double size = mean.segment(first, count).norm();
  if (size > peak.limit) peak.share_beyond += 1.0;
  if (size <= peak.mean) return;
  peak.mean = size;
  peak.time_s = time_s;
}

/// Forces of slides as moments at the robot's size, beside the torques of other joints.
Eigen::MatrixXd of_like_units(const Demand& demand, Eigen::MatrixXd left) {
  for (const Index row : demand.rows.slides) left.row(row) *= demand.size_m;
  return left;
}

/// What noise of derived accelerations may leave beside.
void add_noise(const Demand& demand, BaseResidual& residual) {
  if (demand.residual_noise.size() == 0) return;
  const RowKinds& rows = demand.rows;
  const Eigen::VectorXd noise = of_like_units(demand, demand.residual_noise);
  residual.force.limit += kNoise * noise.head(rows.forces).norm();
  residual.moment.limit += kNoise * noise.segment(rows.forces, rows.moments).norm();
  residual.passive.limit += kNoise * noise.tail(rows.passives).norm();
}

}  // namespace

BaseResidual base_residual(const CheckedMotion& checked) {
  return base_residual(checked, checked.demand.residual);
}

BaseResidual base_residual(const CheckedMotion& checked, const Eigen::MatrixXd& left) {
  const Demand& demand = checked.demand;
  BaseResidual residual;
  residual.window_s = checked.options.residual_window_s;
  residual.force.limit = checked.options.residual_share * demand.weight_N;
  residual.moment.limit = residual.force.limit * demand.size_m;
  residual.passive.limit = residual.moment.limit;
  if (!demand.has_dynamics || left.rows() == 0) return residual;
  const RowKinds& rows = demand.rows;
  add_noise(demand, residual);
  const Eigen::MatrixXd like = of_like_units(demand, left);
  const auto note_all = [&](const Eigen::VectorXd& mean, double time_s) {
    note(mean, 0, rows.forces, time_s, residual.force);
    note(mean, rows.forces, rows.moments, time_s, residual.moment);
    note(mean, rows.forces + rows.moments, rows.passives, time_s, residual.passive);
  };
  // A motion shorter than the window is one; one without duration has its samples alone.
  const double window_s = std::min(residual.window_s, checked.motion.duration_s());
  RunningIntegral integral(checked.motion.times_s, like);
  for (const Jolt& jolt : demand.jolts) {
    integral.add_impulse(jolt.sample, of_like_units(demand, jolt.residual));
  }
  for (Index sample = 0; sample < checked.motion.samples(); ++sample) {
    const double time_s = checked.motion.time_s(sample);
    if (!(window_s > 0.0)) {
      note_all(like.col(sample), time_s);
    } else if (sample == 0 || time_s + window_s <= checked.motion.times_s.back()) {
      note_all(integral.over(sample, window_s) / window_s, time_s);
    }
  }
  for (ResidualPeak* peak : {&residual.force, &residual.moment, &residual.passive}) {
    peak->share_beyond /= static_cast<double>(checked.motion.samples());
  }
  return residual;
}

}  // namespace torquewright::hopper
