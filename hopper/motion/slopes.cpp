// SPDX-License-Identifier: Apache-2.0
#include "hopper/motion/slopes.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

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

/// Slopes over one stretch; `difference(a, b)` leads from sample a to sample b.
template <typename Difference, typename Take>
void fit(const Motion& motion, const Stretch& stretch, const Difference& difference,
         const Take& take) {
  const Index count = stretch.to - stretch.from;
  for (Index sample = stretch.from; sample < stretch.to; ++sample) {
    const auto seconds = [&](Index other) { return motion.time_s(other) - motion.time_s(sample); };
    if (count == 1) {
      const VectorXd none = VectorXd::Zero(motion.velocities.rows());
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

void derive_rates(const dynamics::Tree& tree, Motion& motion) {
  const bool needs_velocity = motion.velocity_origin != Origin::kGiven;
  const bool needs_acceleration = motion.acceleration_origin != Origin::kGiven;
  const Index size = tree.velocity_size();
  const auto of_positions = [&](Index one, Index other) {
    return displacement(tree, motion.positions.col(one), motion.positions.col(other));
  };
  const auto of_velocities = [&](Index one, Index other) -> VectorXd {
    return motion.velocities.col(other) - motion.velocities.col(one);
  };
  if (needs_velocity) motion.velocities.resize(size, motion.samples());
  if (needs_acceleration) motion.accelerations.resize(size, motion.samples());
  for (const Stretch& stretch : stretches(motion)) {
    if (needs_velocity) {
      fit(motion, stretch, of_positions, [&](Index sample, const Parabola& parabola) {
        motion.velocities.col(sample) = parabola.rate;
        if (needs_acceleration) motion.accelerations.col(sample) = parabola.curvature;
      });
    } else if (needs_acceleration) {
      fit(motion, stretch, of_velocities, [&](Index sample, const Parabola& parabola) {
        motion.accelerations.col(sample) = parabola.rate;
      });
    }
  }
  if (needs_velocity) motion.velocity_origin = Origin::kDerived;
  if (needs_acceleration) motion.acceleration_origin = Origin::kDerived;
}

}  // namespace torquewright::hopper
