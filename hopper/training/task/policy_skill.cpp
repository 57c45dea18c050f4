// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/task/policy_skill.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/faults/refusal.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

void set_gains(const Robot& robot, const std::vector<PolicyGain>& stated, const std::string& file,
               TargetGains& gains) {
  for (const PolicyGain& gain : stated) {
    const auto body = robot.find_joint(gain.drive);
    if (!body) {
      io::refuse(file, fmt::format("/gains names \"{}\", which is no joint of {}", gain.drive,
                                   robot.name));
    }
    const auto joint = static_cast<Index>(*body) - 1;
    gains.stiffness_Nm_rad[joint] = gain.stiffness_Nm_rad;
    gains.damping_Nm_s_rad[joint] = gain.damping_Nm_s_rad;
  }
}

}  // namespace

Skill skill_of(const ReadyTask& ready, const PolicyDocument& document, const std::string& file) {
  Skill skill = ready.skill;
  skill.file = file;
  skill.inputs = document.inputs;
  skill.outputs = document.outputs;
  skill.acted = joints_of_outputs(ready.robot, document.outputs, file);
  if (document.control_period_s > 0.0) skill.control_period_s = document.control_period_s;
  if (!document.gains.empty()) set_gains(ready.robot, document.gains, file, skill.gains);
  const Senses known(ready.robot, skill.inputs, skill.phase, file);  // throws where it has them not
  static_cast<void>(known);
  return skill;
}

}  // namespace torquewright::hopper
