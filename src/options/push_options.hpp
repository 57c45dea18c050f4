// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hopper/motion/motion.hpp"
#include "hopper/surroundings/push.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::cli {

/// Reads pushes as the command line has them, "[BODY:]N_S@TIME": without a body on the base, with
/// one number along +x, with three ("x,y,z") along the world's axes. Throws io::SpecError, naming
/// the option and what is allowed, where a text is none, the robot has no such body, a push of
/// nothing or out of the plane of a planar base is asked for, or its time lies outside the motion
/// and the `stand_s` after it.
std::vector<hopper::Push> read_pushes(const std::vector<std::string>& texts,
                                      const hopper::Robot& robot, const hopper::Motion& motion,
                                      double stand_s);

}  // namespace torquewright::cli
