// SPDX-License-Identifier: Apache-2.0
#include "hopper/skill/skill.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/faults/spec_error.hpp"
#include "io/text/nearest.hpp"

namespace torquewright::hopper {

using Eigen::Index;

std::vector<Index> joints_of_outputs(const Robot& robot, const std::vector<PolicyOutput>& outputs,
                                     const std::string& file) {
  std::vector<std::string> names;
  for (std::size_t body = 1; body < robot.tree.bodies.size(); ++body) {
    names.push_back(robot.tree.bodies[body].joint.name + "_target_rad");
  }
  std::vector<io::Fault> faults;
  std::vector<Index> joints;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const auto found = std::find(names.begin(), names.end(), outputs[i].name);
    joints.push_back(found - names.begin());
    if (found != names.end() && outputs[i].unit == "rad") continue;
    const auto nearest = io::nearest(outputs[i].name, names);
    faults.push_back(
        {file, fmt::format("/outputs/{}/name", i),
         fmt::format("\"{}\" in {} is no joint's target of this robot{}", outputs[i].name,
                     outputs[i].unit,
                     nearest ? fmt::format(" (did you mean \"{}\"?)", *nearest) : "")});
  }
  if (!faults.empty()) throw io::SpecError(std::move(faults));
  return joints;
}

ActingSkill::ActingSkill(const Robot& robot, const Skill& skill)
    : skill_(skill),
      senses_(robot, skill.inputs, skill.phase, skill.file),
      law_(robot, skill.gains),
      target_rad_(skill.hold_rad) {}

void ActingSkill::start(const Command& command) {
  senses_.start();
  command_ = command;
  target_rad_ = skill_.hold_rad;
  period_ = 0;
}

void ActingSkill::see(double time_s, const Observation& seen) {
  senses_.note(time_s, seen, target_rad_, command_);
  period_ = std::lround(time_s / skill_.control_period_s);
}

void ActingSkill::act(const Eigen::Ref<const Eigen::VectorXd>& action) {
  for (std::size_t i = 0; i < skill_.acted.size(); ++i) {
    const PolicyOutput& output = skill_.outputs[i];
    target_rad_[skill_.acted[i]] =
        output.offset + course_at(output, period_) + output.scale * action[static_cast<Index>(i)];
  }
}

void ActingSkill::torque(const Observation& seen, Eigen::VectorXd& drive_Nm) const {
  law_.torque(seen.position, seen.velocity, target_rad_, drive_Nm);
}

}  // namespace torquewright::hopper
