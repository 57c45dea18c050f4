// SPDX-License-Identifier: Apache-2.0
// What is called a torque at the output of a drive that moves a slide is a force.
#include <fmt/format.h>

#include "hopper/check/rules/every_rule.hpp"
#include "io/text/wording.hpp"
#include "robot/model/moves_slide.hpp"

namespace torquewright::hopper {

std::vector<Finding> slide_units(const CheckedMotion& checked) {
  std::vector<std::string> names;
  for (const Drivetrain& drivetrain : checked.robot.drivetrains) {
    if (!moves_slide(checked.robot, drivetrain)) continue;
    names.insert(names.end(), drivetrain.actuator_names.begin(), drivetrain.actuator_names.end());
  }
  if (names.empty()) return {};
  Finding finding;
  finding.rule = "slide-units";
  finding.sentence = fmt::format(
      "{}: what moves a slide is a force; at its joint read N for Nm, m/s for rad/s, N s for Nm s",
      io::listed(names));
  return {finding};
}

}  // namespace torquewright::hopper
