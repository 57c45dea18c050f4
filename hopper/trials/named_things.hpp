// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hopper/trials/named_range.hpp"
#include "io/faults/spec_error.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Names of the drives of all drivetrains, in the order that "by drive" means.
std::vector<std::string> drive_names(const Robot& robot);

/// Things of a robot that a range may name, in the robot's order.
struct NamedThings {
  std::string what;  ///< What they are, in words: "body".
  std::vector<std::string> names;
  std::vector<std::string> objections;  ///< Why a thing draws nothing; empty: it does.
};

NamedThings drawing_bodies(const Robot& robot);  ///< Bodies with a mass.
NamedThings drawing_drives(const Robot& robot);
NamedThings drawing_joints(const Robot& robot);  ///< Those that turn; by the bodies after the base.

/// Returns indices of the things that a range is for. Adds a fault for each name that does not
/// exist or that draws nothing.
std::vector<std::size_t> meant_by(const NamedRange& range, const NamedThings& things,
                                  const std::string& file, std::vector<io::Fault>& faults);

}  // namespace torquewright::hopper
