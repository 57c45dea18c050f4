// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "identification/robot/robot_study.hpp"

namespace torquewright::identification {

/// Groups of alike joints without those that are unlike their sisters.
std::vector<std::vector<std::size_t>> groups_without_unlike(
    const RobotStudy& study, const std::vector<std::vector<std::size_t>>& alike);

/// Fits again with one value for each group of alike joints.
ValueFit fit_of_groups(const Log& log, const RobotModel& stated, const RobotStudy& study,
                       const std::vector<std::vector<std::size_t>>& groups,
                       const std::function<void(double share)>& on_progress = {});

/// Fits again what the joints of a robot's document and of simulators hold: armature, damping, dry
/// friction and the controllers' numbers, one for each group of alike joints; with encoders that
/// read what is, and with those errors of bodies of which there is one reading only. A rotor
/// of which the log tells nothing but a bound stays as stated.
ValueFit fit_of_fields(const Log& log, const RobotModel& stated, const RobotStudy& study,
                       const std::vector<std::vector<std::size_t>>& groups,
                       const std::function<void(double share)>& on_progress = {});

/// Errors of bodies that have one reading only.
std::vector<LoadReading> certain_errors(const LoadErrors& load);

}  // namespace torquewright::identification
