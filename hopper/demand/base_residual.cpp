// SPDX-License-Identifier: Apache-2.0
#include "hopper/demand/base_residual.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hopper/demand/running_integral.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

constexpr double kNoise =
    4.0;  // standard deviations that noise may add: normal noise is beyond in 1 of 16,000
constexpr double kLastingWindows = 50.0;  // half a second where the window is 10 ms
// Of the window's limits, as over a flight, where a tenth of momentum lies either way of its mean.
constexpr double kLastingForce = 0.1, kLastingMoment = 0.2;

/// Sizes of force, moment and passive torque of a column of free rows over their limits.
double greatest_over_limit(const RowKinds& rows, const BaseResidual& residual,
                           const Eigen::VectorXd& values) {
  const auto over = [&](Index first, Index count, const ResidualPeak& peak) {
    return count == 0 ? 0.0 : values.segment(first, count).norm() - peak.limit;
  };
  return std::max({over(0, rows.forces, residual.force),
                   over(rows.forces, rows.moments, residual.moment),
                   over(rows.forces + rows.moments, rows.passives, residual.passive)});
}

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
  const double force_N = kNoise * noise.head(rows.forces).norm();
  const double moment_Nm = kNoise * noise.segment(rows.forces, rows.moments).norm();
  const double averaged = std::sqrt(residual.window_s / residual.lasting_window_s);
  residual.force.limit += force_N;
  residual.moment.limit += moment_Nm;
  residual.lasting_force.limit += averaged * force_N;
  residual.lasting_moment.limit += averaged * moment_Nm;
  residual.passive.limit += kNoise * noise.tail(rows.passives).norm();
}

/// A motion shorter than the lasting window may ask for as much more as it is shorter.
void set_limits(const CheckedMotion& checked, BaseResidual& residual) {
  const Demand& demand = checked.demand;
  residual.window_s = checked.options.residual_window_s;
  residual.lasting_window_s = kLastingWindows * residual.window_s;
  residual.force.limit = checked.options.residual_share * demand.weight_N;
  residual.moment.limit = residual.force.limit * demand.size_m;
  residual.passive.limit = residual.moment.limit;
  const double shorter = residual.lasting_window_s / checked.motion.duration_s();
  const auto share = [&](double lasting) {
    return std::min(1.0, lasting * std::max(1.0, shorter));
  };
  residual.lasting_force.limit = share(kLastingForce) * residual.force.limit;
  residual.lasting_moment.limit = share(kLastingMoment) * residual.moment.limit;
  add_noise(demand, residual);
  if (checked.motion.has_forces) {
    residual.lasting_force.limit = residual.lasting_moment.limit =
        std::numeric_limits<double>::infinity();
  }
}

/// Means over windows that begin at every sample. A motion shorter than the window is one; one
/// without duration has its samples alone.
struct Windows {
  const Motion& motion;
  const Eigen::MatrixXd& signal;
  const RunningIntegral& integral;

  template <typename Take>
  void each(double stated_s, const Take& take) const {
    const double window_s = std::min(stated_s, motion.duration_s());
    for (Index sample = 0; sample < motion.samples(); ++sample) {
      const double time_s = motion.time_s(sample);
      if (!(window_s > 0.0)) {
        take(signal.col(sample), sample);
      } else if (sample == 0 || time_s + window_s <= motion.times_s.back()) {
        take(integral.over(sample, window_s) / window_s, sample);
      }
    }
  }
};

}  // namespace

BaseResidual base_residual(const CheckedMotion& checked) {
  return base_residual(checked, checked.demand.residual);
}

BaseResidual base_residual(const CheckedMotion& checked, const Eigen::MatrixXd& left) {
  const Demand& demand = checked.demand;
  BaseResidual residual;
  set_limits(checked, residual);
  if (!demand.has_dynamics || left.rows() == 0) return residual;
  const RowKinds& rows = demand.rows;
  const Eigen::MatrixXd like = of_like_units(demand, left);
  RunningIntegral integral(checked.motion.times_s, like);
  for (const Jolt& jolt : demand.jolts) {
    integral.add_impulse(jolt.sample, of_like_units(demand, jolt.residual));
  }
  const Windows windows{checked.motion, like, integral};
  windows.each(residual.window_s, [&](const Eigen::VectorXd& mean, Index from) {
    const double time_s = checked.motion.time_s(from);
    note(mean, 0, rows.forces, time_s, residual.force);
    note(mean, rows.forces, rows.moments, time_s, residual.moment);
    note(mean, rows.forces + rows.moments, rows.passives, time_s, residual.passive);
  });
  windows.each(residual.lasting_window_s, [&](const Eigen::VectorXd& mean, Index from) {
    const double time_s = checked.motion.time_s(from);
    note(mean, 0, rows.forces, time_s, residual.lasting_force);
    note(mean, rows.forces, rows.moments, time_s, residual.lasting_moment);
  });
  for (ResidualPeak* peak : {&residual.force, &residual.moment, &residual.passive,
                             &residual.lasting_force, &residual.lasting_moment}) {
    peak->share_beyond /= static_cast<double>(checked.motion.samples());
  }
  return residual;
}

std::vector<Index> samples_beyond(const CheckedMotion& checked, const BaseResidual& residual) {
  const Demand& demand = checked.demand;
  const Motion& motion = checked.motion;
  std::vector<Index> found;
  if (!demand.has_dynamics || demand.residual.rows() == 0) return found;
  const Eigen::MatrixXd like = of_like_units(demand, demand.residual);
  const RunningIntegral integral(motion.times_s, like);
  const Windows windows{motion, like, integral};
  windows.each(residual.window_s, [&](const Eigen::VectorXd& mean, Index from) {
    if (greatest_over_limit(demand.rows, residual, mean) <= 0.0) return;
    const double until_s = motion.time_s(from) + residual.window_s;
    for (Index sample = from; sample < motion.samples(); ++sample) {
      const bool is_known = !found.empty() && found.back() >= sample;
      if (!is_known && greatest_over_limit(demand.rows, residual, like.col(sample)) > 0.0) {
        found.push_back(sample);
      }
      if (motion.time_s(sample) >= until_s) break;
    }
  });
  return found;
}

}  // namespace torquewright::hopper
