// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// The robot as a document of kind `robot`; read_robot() reads the same robot back.
nlohmann::ordered_json robot_json(const Robot& robot);

}  // namespace torquewright::hopper
