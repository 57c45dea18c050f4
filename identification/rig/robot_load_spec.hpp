// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "identification/rig/robot_load.hpp"

namespace torquewright::identification {

/// Reads the robot that a load of type "robot" names, beside the rig's file; the joints of the log
/// are not known to it yet. `report` is told the key and the fault of what cannot be: a base that
/// floats and is not said to be held, a joint that its drive moves through a mechanism, a held
/// joint that the robot does not have. Throws io::SpecError for what is wrong in the robot's own
/// document.
RobotLoad robot_load_of_json(
    const nlohmann::json& load, const std::filesystem::path& rig_file,
    const std::function<void(const std::string& key, std::string fault)>& report);

/// Takes the rig's joints, in the robot's order, from those that columns name. `report` is told of
/// names that are no joint's, and of joints that are neither in the log nor held.
std::vector<std::string> joints_in_log(
    const std::vector<std::string>& named, RobotLoad& robot,
    const std::function<void(const std::string& key, std::string fault)>& report);

}  // namespace torquewright::identification
