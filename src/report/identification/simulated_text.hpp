// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/report/identification/robot_report.hpp"

namespace torquewright::report {

/// A table of how far the simulated robot is from its log, by length of window and by joint; then
/// what its motion says of sisters and of bodies.
std::string simulated_text(const RobotReport& robot);

}  // namespace torquewright::report
