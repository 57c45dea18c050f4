// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "identification/robot/robot_study.hpp"
#include "identification/rollout/simulated_errors.hpp"

namespace torquewright::report {

/// What the simulation of a robot under its own loops says, for a report.
struct RobotReport {
  identification::SimulatedErrors errors;
  std::optional<identification::RobotStudy> study;  ///< Where values were fitted.
  /// Whether `errors.after` is of the fitted values; else of the effects that the balance of
  /// torques named.
  bool is_fitted = false;
  /// What documents that were written leave, read back; nothing where none was asked for.
  struct Written {
    std::optional<identification::RobotErrors> robot;   ///< Of the robot's document alone.
    std::optional<identification::RobotErrors> groups;  ///< Of one actuator for each group.
  } written;
  /// Where the two verdicts differ, a sentence for each joint.
  std::vector<std::string> disagreements;
};

/// Sentences on joints that are unlike their sisters, on values that stand for each other, then on
/// errors of the robot's bodies.
std::vector<std::string> robot_findings(const RobotReport& robot);

}  // namespace torquewright::report
