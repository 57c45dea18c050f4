// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "robot/draft/attached_drives.hpp"

namespace torquewright::cli {

/// Returns the robot's document as its file has it, with the drives in it and the files that it
/// names as they are seen from its new place.
std::string robot_with_drives(const std::filesystem::path& robot,
                              const std::filesystem::path& place,
                              const std::vector<hopper::AttachedDrive>& attached);

}  // namespace torquewright::cli
