// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "hopper/planning/plane/sagittal_robot.hpp"

namespace torquewright::hopper {

/// Least load of a foot whose friction is looked at, as a share of the weight: under less a foot
/// that slips pushes nothing.
inline constexpr double kLeastLoad = 0.05;

/// What the ends of a sole get from the ground in a sample of a motion.
struct SoleLoad {
  double along_N = 0.0;
  double rear_N = 0.0;  ///< Upwards.
  double fore_N = 0.0;

  double load_N() const { return rear_N + fore_N; }
  /// Returns the share of the load that the end bears which bears less; 1 without a load.
  double lesser_share() const { return load_N() > 0.0 ? std::min(rear_N, fore_N) / load_N() : 1.0; }
  /// The friction coefficient that it takes; infinite without a load.
  double friction() const {
    return load_N() > 0.0 ? std::abs(along_N) / load_N() : std::numeric_limits<double>::infinity();
  }
};

/// `forces_N` (3 contact points x samples), world's axes, on the robot.
inline SoleLoad sole_load(const SagittalRobot& plane, const Eigen::MatrixXd& forces_N,
                          Eigen::Index sample) {
  SoleLoad out;
  for (const SolePoint& point : plane.sole) {
    double up_N = 0.0;
    for (const std::size_t member : point.members) {
      const Eigen::Index row = 3 * static_cast<Eigen::Index>(member);
      out.along_N += forces_N(row, sample);
      up_N += forces_N(row + 2, sample);
    }
    (&point == &plane.sole.front() ? out.rear_N : out.fore_N) += up_N;
  }
  return out;
}

}  // namespace torquewright::hopper
