// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Drives that a name stands for, by their index among all drives.
struct DriveGroup {
  std::string name;
  std::vector<std::size_t> drives;
};

/// Returns every drive by its name, and every drivetrain of several by the words that their names
/// begin with: "ankle" of ankle_left and ankle_right. A name that would stand for two of them is
/// left out.
std::vector<DriveGroup> drive_groups(const Robot& robot);

/// Returns the drives of a name; none where the name does not exist.
std::optional<std::vector<std::size_t>> drives_named(const Robot& robot, const std::string& name);

std::vector<std::size_t> every_drive(const Robot& robot);
std::vector<std::string> every_drive_name(const Robot& robot);

const actuator::Actuator& drive_at(const Robot& robot, std::size_t drive);
actuator::Actuator& drive_at(Robot& robot, std::size_t drive);

/// Throws io::SpecError for an unknown name, listing the names that there are, each with `ending`
/// too.
[[noreturn]] void refuse_name(const std::string& place, const std::string& name,
                              const std::vector<std::string>& known, std::string_view ending);

}  // namespace torquewright::hopper
