// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>

#include "actuator/trajectory/trajectory_reader.hpp"
#include "hopper/motion/bare_rows.hpp"
#include "hopper/motion/channel.hpp"
#include "hopper/motion/motion.hpp"
#include "io/documents/document.hpp"

namespace torquewright::hopper {

struct MotionFile {
  std::filesystem::path file;
  std::vector<std::string> mappings;    ///< NAME=OWNER.QUANTITY[:unit][*factor]
  std::vector<io::Document> documents;  ///< Documents of kind trajectory_columns.
  actuator::Window window;
  BareRows bare = {};  ///< Of a file without a header.
  /// Called with the share that is done. May be empty.
  std::function<void(double share)> on_progress = {};
};

/// Reads a whole-body motion of a robot from a CSV with canonical headers (channels_of()) or mapped
/// ones. Rates that it lacks are left to derive_rates(). Throws io::SpecError: columns of another
/// robot (with the nearest names), joints without a position, some coordinates of the base and not
/// all, a base that floats with nothing said of it where torques are missing too, time that runs
/// backwards or repeats where positions differ, turns that jump (whole turns are taken out and
/// noted), a quaternion whose length is not 1, contact flags other than 0 and 1, columns named like
/// these in other units that nobody stated, no rows.
Motion read_motion(const Robot& robot, const MotionFile& source);

}  // namespace torquewright::hopper
