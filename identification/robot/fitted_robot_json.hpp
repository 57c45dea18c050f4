// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "identification/robot/joint_fields.hpp"
#include "io/documents/document.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::identification {

/// The robot's document with joints that hold what a fit of their fields gave, and with those
/// errors of bodies of which there is one reading only. Joints that a mechanism moves keep what
/// they state: their drives have documents of their own.
nlohmann::ordered_json fitted_robot(const io::Document& nominal, const Rig& rig,
                                    const RobotModel& fitted, const LoadErrors& load);

/// A robot that was read, as what the rig's joints move: its bodies and drives, under these
/// controllers, with encoders that read what is.
RobotModel model_of_robot(const hopper::Robot& robot, const Rig& rig,
                          const std::vector<JointController>& controllers);

}  // namespace torquewright::identification
