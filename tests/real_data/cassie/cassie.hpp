// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "robot/model/robot.hpp"

namespace torquewright::test {

/// Its makers' file, and its authors' jump; empty where they are absent.
std::filesystem::path cassie_file();
std::filesystem::path published_jump_file();

/// Cassie as `robot import` reads it: leaf springs, rods and cranks, both ends of each foot's edge
/// as contacts; with the drives of specs/actuator.
hopper::Robot cassie();

}  // namespace torquewright::test
