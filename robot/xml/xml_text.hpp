// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tinyxml2.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Where a format demands a range and the robot has none: the widest that a robot document holds.
inline constexpr double kNoRange = 1e4;
/// Where a format demands a limit of effort or speed and the robot has none. Readers keep limits as
/// they stand, some in single precision, and take zero for no force at all: this is beyond every
/// drive and finite for all of them, and our own import reads it as no limit.
inline constexpr double kNoLimit = 1e9;

/// As io::precise_text has it: read back they are the same.
std::string text_of(double value);
std::string text_of(const Eigen::Vector3d& vector);

/// The one list, then the other.
std::vector<std::string> joined(std::vector<std::string> notes,
                                const std::vector<std::string>& more);

/// Writes the notes as a comment at the file's head.
void write_notes(tinyxml2::XMLPrinter& out, const std::vector<std::string>& notes);

/// Parts of a robot that a file may leave out.
struct LeftOut {
  bool contacts = true;
  bool drives = true;
  bool links = true;  ///< Those of loops.
};

/// Adds what a file does not hold of the joints' passive forces.
void add_passive_notes(const Robot& robot, bool holds_springs, std::vector<std::string>& notes);

/// What a file does not hold of this robot.
void add_common_notes(const Robot& robot, const LeftOut& left_out, std::vector<std::string>& notes);

}  // namespace torquewright::hopper
