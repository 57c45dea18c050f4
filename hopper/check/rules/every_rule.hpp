// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "hopper/demand/checked_motion.hpp"

namespace torquewright::hopper {

/// A rule that a motion may break beside the regions of its actuators. Each is one file and one
/// line here; docs/checks.md says what it looks at.
using Rule = std::vector<Finding> (*)(const CheckedMotion& checked);

/// Share of the weight: what carries less bears no load, so that it has no centre of pressure and
/// the ratio of its forces says nothing. A choice of ours.
constexpr double kBearsLoad = 0.01;

std::vector<Finding> center_of_pressure(const CheckedMotion& checked);
std::vector<Finding> contact_above_ground(const CheckedMotion& checked);
std::vector<Finding> friction_cone(const CheckedMotion& checked);
std::vector<Finding> friction_sliding(const CheckedMotion& checked);
std::vector<Finding> ground_penetration(const CheckedMotion& checked);
std::vector<Finding> impact_by_motors(const CheckedMotion& checked);
std::vector<Finding> impact_energy(const CheckedMotion& checked);
std::vector<Finding> joint_limits(const CheckedMotion& checked);
std::vector<Finding> joint_without_drive(const CheckedMotion& checked);
std::vector<Finding> mechanism_margins(const CheckedMotion& checked);
std::vector<Finding> self_collision(const CheckedMotion& checked);
std::vector<Finding> slide_units(const CheckedMotion& checked);

constexpr std::array<Rule, 12> kEveryRule{
    joint_limits,     mechanism_margins, ground_penetration,  contact_above_ground,
    friction_cone,    friction_sliding,  center_of_pressure,  self_collision,
    impact_by_motors, impact_energy,     joint_without_drive, slide_units};

}  // namespace torquewright::hopper
