// SPDX-License-Identifier: Apache-2.0
#include "robot/model/mechanism_reach.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace torquewright::hopper {
namespace {

bool is_reached(const Mechanism& mechanism, const SmallVector& joint_rad) {
  return mechanism.transfer(joint_rad, SmallVector::Zero(joint_rad.size())).has_value();
}

}  // namespace

SmallVector home_posture_rad(const dynamics::Tree& tree, const std::vector<std::size_t>& joints) {
  SmallVector home(static_cast<Eigen::Index>(joints.size()));
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const dynamics::JointLimits& limits = tree.bodies[joints[i]].joint.limits;
    home[static_cast<Eigen::Index>(i)] = std::clamp(0.0, limits.position_min, limits.position_max);
  }
  return home;
}

void reach_faults(const dynamics::Tree& tree, const Drivetrain& drivetrain, const io::Fault& place,
                  std::vector<io::Fault>& faults) {
  const SmallVector home = home_posture_rad(tree, drivetrain.joints);
  const auto report = [&](const std::string& joint, double end_rad) {
    faults.push_back({place.file, place.path,
                      fmt::format("the linkage does not reach {} = {:.4g} rad, or is singular "
                                  "there: it is within the joint's range_rad",
                                  joint, end_rad)});
  };
  if (!is_reached(*drivetrain.mechanism, home)) {
    report(tree.bodies[drivetrain.joints.front()].joint.name, home[0]);
    return;
  }
  for (std::size_t i = 0; i < drivetrain.joints.size(); ++i) {
    const dynamics::Joint& joint = tree.bodies[drivetrain.joints[i]].joint;
    for (const double end : {joint.limits.position_min, joint.limits.position_max}) {
      SmallVector posture = home;
      posture[static_cast<Eigen::Index>(i)] = end;
      if (std::isfinite(end) && !is_reached(*drivetrain.mechanism, posture)) {
        report(joint.name, end);
      }
    }
  }
}

}  // namespace torquewright::hopper
