// SPDX-License-Identifier: Apache-2.0
#include "tests/robot/mechanisms/joint_position.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>

namespace torquewright::test {
namespace {

using hopper::Mechanism;
using hopper::SmallVector;
using hopper::Transfer;

constexpr double kFound = 1e-12;      // rad at the actuators, some thousand roundings of a turn
constexpr double kLongestStep = 0.5;  // rad: a longer one may land in another posture
constexpr double kShortestShare = 1e-6;
constexpr int kMostSteps = 60;

SmallVector missing_rad(const SmallVector& wanted_rad, const Transfer& at) {
  SmallVector missing = wanted_rad - at.actuator_position_rad;
  for (double& angle : missing) angle = std::remainder(angle, 2 * std::numbers::pi);
  return missing;
}

}  // namespace

std::optional<SmallVector> joint_position_rad(const Mechanism& mechanism,
                                              const SmallVector& actuator_rad,
                                              const SmallVector& start_rad) {
  const SmallVector rest = SmallVector::Zero(mechanism.size());
  SmallVector joints = start_rad;
  auto at = mechanism.transfer(joints, rest);
  for (int step = 0; at && step < kMostSteps; ++step) {
    const SmallVector missing = missing_rad(actuator_rad, *at);
    if (missing.cwiseAbs().maxCoeff() <= kFound) return joints;
    const SmallVector full = at->jacobian.partialPivLu().solve(missing);
    double share = std::min(1.0, kLongestStep / full.norm());
    for (; share > kShortestShare; share /= 2) {
      const SmallVector next = joints + share * full;
      const auto there = mechanism.transfer(next, rest);
      if (!there || missing_rad(actuator_rad, *there).norm() >= missing.norm()) continue;
      joints = next;
      at = there;
      break;
    }
    if (share <= kShortestShare) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace torquewright::test
