// SPDX-License-Identifier: Apache-2.0
#include "hopper/motion/slopes.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/faults/refusal.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Index kWide = 65;  // samples: beyond, all rows at once

/// First and second derivative of x(t) = rate t + curvature t^2 / 2, which passes through the
/// displacements at the times from the sample's own.
struct Parabola {
  VectorXd rate;
  VectorXd curvature;
};

Parabola through(const VectorXd& one, double one_s, const VectorXd& other, double other_s) {
  return {(one * (other_s / one_s) - other * (one_s / other_s)) / (other_s - one_s),
          2.0 * (other / other_s - one / one_s) / (other_s - one_s)};
}

/// What each displacement counts in rate and curvature of the parabola c + r s + k s^2 / 2 that
/// fits them by least squares.
struct Weights {
  VectorXd rate;
  VectorXd curvature;
};

Weights least_squares(const VectorXd& from_own_s) {
  const double scale_s = from_own_s.cwiseAbs().maxCoeff();
  Eigen::MatrixX3d columns(from_own_s.size(), 3);
  columns.col(0).setOnes();
  columns.col(1) = from_own_s / scale_s;
  columns.col(2) = 0.5 * columns.col(1).cwiseAbs2();
  const Eigen::Matrix3d normal = columns.transpose() * columns;
  const Eigen::Matrix3Xd solved = normal.ldlt().solve(columns.transpose());
  return {solved.row(1).transpose() / scale_s, solved.row(2).transpose() / (scale_s * scale_s)};
}

/// Samples [from, to) without a break inside.
struct Stretch {
  Index from;
  Index to;
};

std::vector<Stretch> stretches(const Motion& motion) {
  std::vector<Stretch> found;
  Index from = 0;
  for (const Index sample : motion.breaks) {
    found.push_back({from, sample});
    from = sample;
  }
  found.push_back({from, motion.samples()});
  return found;
}

VectorXd times_from(const Motion& motion, Index sample, Index first, Index count) {
  VectorXd from_own_s(count);
  for (Index i = 0; i < count; ++i) {
    from_own_s[i] = motion.time_s(first + i) - motion.time_s(sample);
  }
  return from_own_s;
}

template <typename Difference>
Parabola fitted(const Motion& motion, Index sample, Index first, Index count,
                const Difference& difference) {
  const Weights weights = least_squares(times_from(motion, sample, first, count));
  const VectorXd start = difference(sample, first);
  Parabola parabola{weights.rate[0] * start, weights.curvature[0] * start};
  for (Index i = 1; i < count; ++i) {
    const VectorXd step = difference(sample, first + i);
    parabola.rate += weights.rate[i] * step;
    parabola.curvature += weights.curvature[i] * step;
  }
  return parabola;
}

/// Parabolas over wide windows of a table whose rows are what is differentiated.
template <typename Take>
void fit_table(const Motion& motion, const Stretch& stretch, Index wide, Index reach,
               const Eigen::MatrixXd& table, const Take& take) {
  for (Index sample = stretch.from; sample < stretch.to; ++sample) {
    const Index first = std::clamp(sample - reach, stretch.from, stretch.to - wide);
    const Weights weights = least_squares(times_from(motion, sample, first, wide));
    // Weights of either kind sum to zero: they count differences from the sample's own.
    const auto window = table.middleCols(first, wide);
    take(sample, Parabola{window * weights.rate, window * weights.curvature});
  }
}

/// Slopes over one stretch; `difference(a, b)` leads from sample a to sample b.
template <typename Difference, typename Take>
void fit(const Motion& motion, const Stretch& stretch, Index reach, const Difference& difference,
         const Take& take) {
  const Index count = stretch.to - stretch.from;
  const Index wide = std::min(2 * reach + 1, count);
  for (Index sample = stretch.from; sample < stretch.to; ++sample) {
    if (wide > 3) {
      const Index first = std::clamp(sample - reach, stretch.from, stretch.to - wide);
      take(sample, fitted(motion, sample, first, wide, difference));
      continue;
    }
    const auto seconds = [&](Index other) { return motion.time_s(other) - motion.time_s(sample); };
    if (count == 1) {
      const VectorXd none = VectorXd::Zero(difference(sample, sample).size());
      take(sample, Parabola{none, none});
    } else if (count == 2) {
      const Index other = sample == stretch.from ? sample + 1 : sample - 1;
      const VectorXd rate = difference(sample, other) / seconds(other);
      take(sample, Parabola{rate, VectorXd::Zero(rate.size())});
    } else {
      const Index one = sample == stretch.from     ? sample + 1
                        : sample == stretch.to - 1 ? sample - 2
                                                   : sample - 1;
      const Index other = sample == stretch.from     ? sample + 2
                          : sample == stretch.to - 1 ? sample - 1
                                                     : sample + 1;
      take(sample, through(difference(sample, one), seconds(one), difference(sample, other),
                           seconds(other)));
    }
  }
}

}  // namespace

VectorXd displacement(const dynamics::Tree& tree, const VectorXd& from, const VectorXd& to) {
  if (tree.base != dynamics::BaseKind::kSpatial) return to - from;
  const auto rotation = [](const VectorXd& at) {
    return Eigen::Quaterniond(at[3], at[4], at[5], at[6]).normalized();
  };
  const Eigen::AngleAxisd turn(rotation(from).conjugate() * rotation(to));
  // The shorter way round: Eigen's angles run from 0 to 2 pi.
  const double angle_rad = std::remainder(turn.angle(), 2.0 * std::numbers::pi);
  VectorXd step(tree.velocity_size());
  const Index joints = step.size() - 6;
  step << to.head<3>() - from.head<3>(), angle_rad * turn.axis(),
      to.tail(joints) - from.tail(joints);
  return step;
}

bool has_given_velocity(const Motion& motion) { return motion.velocity_origin == Origin::kGiven; }

Eigen::MatrixXd spread_as_accelerations(const Motion& motion, const Eigen::MatrixXd& table) {
  const bool once = has_given_velocity(motion);
  Eigen::MatrixXd integral = Eigen::MatrixXd::Zero(table.rows(), table.cols());
  Eigen::MatrixXd twice = integral;
  for (Index i = 0; i + 1 < motion.samples(); ++i) {
    const double step_s = motion.step_s(i);
    integral.col(i + 1) = integral.col(i) + 0.5 * step_s * (table.col(i) + table.col(i + 1));
    twice.col(i + 1) = twice.col(i) + step_s * integral.col(i) +
                       step_s * step_s / 6.0 * (2.0 * table.col(i) + table.col(i + 1));
  }
  Eigen::MatrixXd spread(table.rows(), table.cols());
  const auto difference = [&](Index one, Index other) -> VectorXd {
    return once ? integral.col(other) - integral.col(one) : twice.col(other) - twice.col(one);
  };
  for (const Stretch& stretch : stretches(motion)) {
    fit(motion, stretch, motion.reach, difference, [&](Index sample, const Parabola& parabola) {
      spread.col(sample) = once ? parabola.rate : parabola.curvature;
    });
  }
  return spread;
}

FittedAcceleration fitted_acceleration(const dynamics::Tree& tree, const Motion& motion,
                                       Index sample, Index reach) {
  const Index first = sample - reach;
  const Index count = 2 * reach + 1;
  const bool by_velocity = has_given_velocity(motion);
  const Weights weights = least_squares(times_from(motion, sample, first, count));
  const VectorXd& counts = by_velocity ? weights.rate : weights.curvature;
  FittedAcceleration found{VectorXd::Zero(tree.velocity_size()), counts.norm()};
  for (Index i = 0; i < count; ++i) {
    found.acceleration +=
        counts[i] *
        (by_velocity
             ? VectorXd(motion.velocities.col(first + i) - motion.velocities.col(sample))
             : displacement(tree, motion.positions.col(sample), motion.positions.col(first + i)));
  }
  return found;
}

Amplification amplification(const Motion& motion, Index reach) {
  Amplification found{VectorXd::Zero(motion.samples()), VectorXd::Zero(motion.samples())};
  const bool by_velocity = has_given_velocity(motion);
  for (const Stretch& stretch : stretches(motion)) {
    const Index count = stretch.to - stretch.from;
    const Index wide = std::min(2 * reach + 1, count);
    if (wide < 3) continue;
    const Index first = stretch.from + (count - wide) / 2;
    const Weights weights = least_squares(times_from(motion, first + wide / 2, first, wide));
    const VectorXd& counts = by_velocity ? weights.rate : weights.curvature;
    found.noise.segment(stretch.from, count).setConstant(counts.norm());
    found.most.segment(stretch.from, count).setConstant(counts.cwiseAbs().sum());
  }
  return found;
}

/// A line goes through two rows, a parabola through three.
void require_rows(const Motion& motion, bool needs_velocity, bool needs_acceleration) {
  const Index least = needs_velocity && needs_acceleration   ? 3
                      : needs_velocity || needs_acceleration ? 2
                                                             : 1;
  if (motion.samples() >= least) return;
  io::refuse(
      motion.file,
      fmt::format("{} cannot be had from fewer than {} rows, and there {}; state them in the "
                  "file, or take more rows (--from, --until)",
                  needs_acceleration ? "accelerations" : "velocities", least,
                  motion.samples() == 1 ? "is one" : "are two"));
}

void derive_rates(const dynamics::Tree& tree, Motion& motion, Index reach) {
  const bool needs_velocity = motion.velocity_origin != Origin::kGiven;
  const bool needs_acceleration = motion.acceleration_origin != Origin::kGiven;
  require_rows(motion, needs_velocity, needs_acceleration);
  const Index size = tree.velocity_size();
  const auto of_positions = [&](Index one, Index other) {
    return displacement(tree, motion.positions.col(one), motion.positions.col(other));
  };
  const auto of_velocities = [&](Index one, Index other) -> VectorXd {
    return motion.velocities.col(other) - motion.velocities.col(one);
  };
  if (needs_velocity || needs_acceleration) motion.reach = reach;
  if (needs_velocity) motion.velocities.resize(size, motion.samples());
  if (needs_acceleration) motion.accelerations.resize(size, motion.samples());
  const auto fill = [&](Index sample, const Parabola& parabola) {
    motion.velocities.col(sample) = parabola.rate;
    if (needs_acceleration) motion.accelerations.col(sample) = parabola.curvature;
  };
  const bool is_linear = tree.base != dynamics::BaseKind::kSpatial;
  for (const Stretch& stretch : stretches(motion)) {
    const Index wide = std::min(2 * reach + 1, stretch.to - stretch.from);
    if (wide > kWide && !needs_velocity && needs_acceleration) {
      fit_table(motion, stretch, wide, reach, motion.velocities,
                [&](Index sample, const Parabola& parabola) {
                  motion.accelerations.col(sample) = parabola.rate;
                });
    } else if (wide > kWide && needs_velocity && is_linear) {
      fit_table(motion, stretch, wide, reach, motion.positions, fill);
    } else if (needs_velocity) {
      fit(motion, stretch, reach, of_positions, fill);
    } else if (needs_acceleration) {
      fit(motion, stretch, reach, of_velocities, [&](Index sample, const Parabola& parabola) {
        motion.accelerations.col(sample) = parabola.rate;
      });
    }
  }
  if (needs_velocity) motion.velocity_origin = Origin::kDerived;
  if (needs_acceleration) motion.acceleration_origin = Origin::kDerived;
}

}  // namespace torquewright::hopper
