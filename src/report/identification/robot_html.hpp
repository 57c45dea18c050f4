// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "identification/answer/identify.hpp"
#include "src/report/identification/robot_report.hpp"
#include "src/report/parts/html_page.hpp"

namespace torquewright::report {

/// The robot as a section of the page: its joints by what was found and what is left there, each
/// joint's error by time, the values that its motion gives, and what it says of sisters and bodies.
std::string robot_section(const identification::Identification& found, const RobotReport& robot,
                          Pictures& pictures);

/// Simulated less measured position of each joint over one run that was held out, where there is
/// one: a script for gnuplot, a strip for each joint.
std::string joint_errors_plot(const identification::SimulatedErrors& errors);

}  // namespace torquewright::report
