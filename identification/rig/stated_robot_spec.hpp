// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace torquewright::io {
struct Document;
}

namespace torquewright::identification {

/// States the robot of that file, its base held, as the load of a rig that says none, as one has
/// that was drafted or imported. Throws io::SpecError where the rig says what was moved.
void state_robot(const std::filesystem::path& robot, io::Document& rig);

}  // namespace torquewright::identification
