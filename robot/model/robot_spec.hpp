// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "io/documents/document.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// A robot and every document that was read for it: its own first, then its actuators'.
struct ReadRobot {
  Robot robot;
  std::vector<io::Document> documents;
};

/// Reads a document of kind `robot`. Bodies are put parents first, whatever their order in the
/// document. A joint that states no reflected inertia has that of its actuator where the mechanism
/// is direct, and zero otherwise. Throws io::SpecError with all faults that a schema cannot say:
/// names that are unknown (with the nearest) or stand twice, bodies that hang on nothing or on two
/// joints (a closed loop), inertias no body has, limits upside down or of the wrong kind of joint,
/// mechanisms that do not fit, and the faults of the actuators' own documents.
ReadRobot read_robot(const std::filesystem::path& file);
/// Reads a robot from a document that is read already; files it names are beside document.file.
ReadRobot robot_of(io::Document document);

}  // namespace torquewright::hopper
