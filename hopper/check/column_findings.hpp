// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "actuator/drive_check/report.hpp"
#include "hopper/motion/motion_reader.hpp"

namespace torquewright::hopper {

/// Returns notes on columns that read_motion() does not read, and on those that it reads in another
/// unit than their own names end in. For a file that comes through a pipe, which is read once, only
/// the latter. Requires a file that read_motion() has read.
std::vector<actuator::Finding> column_findings(const Robot& robot, const MotionFile& source);

}  // namespace torquewright::hopper
