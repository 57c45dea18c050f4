// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "actuator/mor/need.hpp"
#include "src/command_line/command_line.hpp"

namespace torquewright::cli {

/// What an option may ask for at most; beyond it nothing is an actuator.
constexpr double kMostTorque_Nm = 1e9;
constexpr double kMostSpeed_rad_s = 1e6;

/// TORQUE@SPEED of an option, in Nm and rad/s where no units stand behind the numbers: 100@95rpm,
/// and at the end of a lever 20N@0.3m/s. Throws io::SpecError for what is no need.
actuator::Need read_need(const std::string& option, const std::string& text,
                         std::optional<double> lever_m);

/// Throws io::SpecError where a lever is stated and none of the needs is along a line.
void require_use_of_lever(std::optional<double> lever_m, const std::vector<std::string>& needs);

/// The lever of needs along a line, in m.
void add_lever(command_line::Command& command, std::optional<double>& lever_m);

/// LOW:HIGH of an option: least and greatest of the gear ratios to be tried. Throws io::SpecError
/// for what is no range of ratios.
std::pair<double, double> read_ratio_range(const std::string& option, const std::string& text);

}  // namespace torquewright::cli
