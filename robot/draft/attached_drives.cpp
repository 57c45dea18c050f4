// SPDX-License-Identifier: Apache-2.0
#include "robot/draft/attached_drives.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/faults/refusal.hpp"
#include "io/text/name_pattern.hpp"
#include "io/text/nearest.hpp"
#include "io/text/wording.hpp"

namespace torquewright::hopper {
namespace {

std::vector<std::string> names_of_joints(const Robot& robot) {
  std::vector<std::string> names;
  for (std::size_t body = 1; body < robot.tree.bodies.size(); ++body) {
    names.push_back(robot.tree.bodies[body].joint.name);
  }
  return names;
}

void require_fits(const std::string& pattern, const std::vector<std::string>& joints) {
  const bool fits = std::any_of(joints.begin(), joints.end(), [&](const std::string& joint) {
    return io::fits_pattern(joint, pattern);
  });
  if (fits) return;
  const auto near = io::nearest(pattern, joints);
  io::refuse(pattern, near ? fmt::format("fits no joint; did you mean \"{}\"?", *near)
                           : "fits no joint; the robot's are " + io::listed(joints));
}

/// The pattern that fits a joint; null if none does.
const DrivePattern* only_pattern_of(const std::string& joint,
                                    const std::vector<DrivePattern>& patterns) {
  const DrivePattern* found = nullptr;
  for (const DrivePattern& each : patterns) {
    if (!io::fits_pattern(joint, each.pattern)) continue;
    if (found != nullptr) {
      io::refuse(each.pattern, fmt::format("fits {} too, which \"{}\" fits: a joint has one drive",
                                           joint, found->pattern));
    }
    found = &each;
  }
  return found;
}

/// Whether the joint has a drive of its own; throws where a linkage turns it.
bool is_driven(const Robot& robot, std::size_t body, const std::string& pattern) {
  for (const Drivetrain& train : robot.drivetrains) {
    if (std::find(train.joints.begin(), train.joints.end(), body) == train.joints.end()) continue;
    if (train.joints.size() == 1 && train.mechanism->type() == "direct") return true;
    io::refuse(pattern, fmt::format("fits {}, which a {} turns: its drives stand at that mechanism",
                                    robot.tree.bodies[body].joint.name, train.mechanism->type()));
  }
  return false;
}

}  // namespace

std::vector<AttachedDrive> attached_drives(const Robot& robot,
                                           const std::vector<DrivePattern>& patterns) {
  const std::vector<std::string> joints = names_of_joints(robot);
  for (const DrivePattern& each : patterns) require_fits(each.pattern, joints);
  std::vector<AttachedDrive> attached;
  for (std::size_t body = 1; body < robot.tree.bodies.size(); ++body) {
    const std::string& joint = joints[body - 1];
    const DrivePattern* pattern = only_pattern_of(joint, patterns);
    if (pattern == nullptr) continue;
    attached.push_back({joint, pattern->file, is_driven(robot, body, pattern->pattern)});
  }
  return attached;
}

}  // namespace torquewright::hopper
