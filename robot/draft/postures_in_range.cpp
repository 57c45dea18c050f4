// SPDX-License-Identifier: Apache-2.0
#include "robot/draft/postures_in_range.hpp"

#include <cmath>

#include "robot/model/mechanism_reach.hpp"

namespace torquewright::hopper {
namespace {

constexpr int kPostures = 9;      // along the range of each joint
constexpr double kReach_rad = 1;  // where a joint has no range

double posture_rad(const dynamics::JointLimits& limits, double home_rad, int step) {
  const double share = static_cast<double>(step) / (kPostures - 1);
  const bool has_range = std::isfinite(limits.position_min) && std::isfinite(limits.position_max);
  const double least = has_range ? limits.position_min : home_rad - kReach_rad;
  const double most = has_range ? limits.position_max : home_rad + kReach_rad;
  return least + share * (most - least);
}

}  // namespace

std::vector<SmallVector> postures_in_range(const dynamics::Tree& tree,
                                           const Drivetrain& drivetrain) {
  const SmallVector home = home_posture_rad(tree, drivetrain.joints);
  const int count = home.size() > 1 ? kPostures * kPostures : kPostures;
  std::vector<SmallVector> postures;
  for (int sample = 0; sample < count; ++sample) {
    SmallVector q = home;
    for (Eigen::Index k = 0; k < home.size(); ++k) {
      const auto& limits = tree.bodies[drivetrain.joints[static_cast<std::size_t>(k)]].joint.limits;
      q[k] = posture_rad(limits, home[k], k == 0 ? sample % kPostures : sample / kPostures);
    }
    postures.push_back(q);
  }
  return postures;
}

}  // namespace torquewright::hopper
