// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "gearbox/constraints/design_report.hpp"

namespace torquewright::report {

/// "24.9 mm", or the bare number where the unit is 1.
std::string with_unit(double value, const std::string& unit);

/// Teeth, objective, ratio, assembly, efficiency, sizes, inertia and torques, a line each.
std::string design_summary(const gearbox::Problem& problem, const gearbox::DesignReport& report);

/// How much of the load the teeth bear, where one is stated; what is assumed for it.
std::string strength_line(const gearbox::Problem& problem, const gearbox::DesignReport& report);

/// A line of a design: its title, and what is said of it.
std::string design_line(const std::string& title, const std::string& text);

/// The summary, what of the load its teeth bear, and the constraints that leave least.
std::string design_screen(const gearbox::Problem& problem, const gearbox::DesignReport& report);

/// The summary, then tables of gears and meshes, every constraint and every remark.
std::string design_text(const gearbox::Problem& problem, const gearbox::DesignReport& report);

/// What one does with a screen that shows the best design of a problem: the commands that say more.
std::string next_text(const std::string& problem_file, const gearbox::Problem& problem);

}  // namespace torquewright::report
