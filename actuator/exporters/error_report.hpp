// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "actuator/exporters/exporter.hpp"

namespace torquewright::actuator {

/// The greatest difference of one kind, and the speed at which it is. 0 at 0: there is none.
struct WorstError {
  double torque_Nm = 0.0;
  double speed_rad_s = 0.0;
};

/// Driving or braking in one direction of motion, or one bound at rest.
struct QuadrantError {
  int direction;          ///< Sign of the speed; 0: at rest, where a bound may jump.
  bool is_upper;          ///< Torque above zero; else below.
  WorstError optimistic;  ///< The simulator gives torque that the actuator does not.
  WorstError cautious;    ///< The actuator gives torque that the simulator does not.
};

/// What a simulator does with a shape, and with the friction of its joint if it has the drive's,
/// against the region, over every speed up to the region's
/// greatest. Where its law contradicts itself or sets no limit, a sentence says so, and the speeds
/// count in no number; so where the region is empty.
struct ErrorReport {
  double greatest_speed_rad_s = 0.0;
  std::array<QuadrantError, 4> quadrants;
  std::array<QuadrantError, 2> at_rest;  ///< Both directions' union against the law at 0.
  /// Where the joint has the friction: of a command of half the law's limit, for which the drive's
  /// motor brings as much. Optimistic: more torque in the command's direction than the drive's.
  std::optional<std::array<QuadrantError, 4>> at_half = {};
  /// The share of the area of torque and speed allowed by the law that the region does not allow.
  double share_outside = 0.0;
  std::vector<std::string> sentences;
};

/// "driving" where torque and motion have one sign, "braking", "at rest".
std::string_view mode_of(const QuadrantError& error);

ErrorReport error_report(const Subject& subject, const Exporter& exporter,
                         std::span<const double> shape);

/// The report as a table of text, a line each.
std::vector<std::string> error_lines(const ErrorReport& report);

}  // namespace torquewright::actuator
