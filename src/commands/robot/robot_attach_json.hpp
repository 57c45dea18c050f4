// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
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

/// How many of these joints state in that document what their rotor weighs, which then holds in the
/// place of their drive's rotor.
std::size_t count_own_rotors(const std::string& document,
                             const std::vector<hopper::AttachedDrive>& attached);

}  // namespace torquewright::cli
