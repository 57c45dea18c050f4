// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "identification/rig/joint_controller.hpp"

namespace torquewright::identification {

/// Reads the joints' controllers: "controller" for all of them, and "controllers" by joint or
/// pattern ("*_calf_joint"), which goes before it; with what "uncertain" leaves open of them. One
/// for each joint, in their order; empty where the rig states none. `report` is told the pointer
/// and fault of a pattern that fits no joint, and of a law without its gain.
std::vector<std::optional<JointController>> controllers_of_json(
    const nlohmann::json& rig, const std::vector<std::string>& joints,
    const std::function<void(const std::string& pointer, std::string fault)>& report);

}  // namespace torquewright::identification
