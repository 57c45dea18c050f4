// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "actuator/drive_check/drive_check.hpp"

namespace torquewright::actuator {

/// The coldest or the warmest state of a winding in the last run of a motion, at which the drive is
/// judged too.
struct HeatEnd {
  double winding_K = 0.0;
  /// Whether the winding is within kSteady_K of the conditions asked for, whose result then holds.
  bool is_as_asked = false;
  /// The conditions asked for, with the winding at that temperature.
  OperatingConditions conditions;
  std::string objection;  ///< Why the document does not reach there; empty: it does.

  bool is_to_be_judged() const { return !is_as_asked && objection.empty(); }
};

/// Returns the coldest end and, of several runs, the warmest; a single run is judged by its start.
/// Empty where the temperature was stated or is not known, and where it has no bound.
std::vector<HeatEnd> heat_ends(const CheckedDrive& drive, const DriveReport& as_asked);

/// Whether the drive has yet to be judged at other conditions than those asked for.
bool need_judging(const DriveReport& as_asked, const std::vector<HeatEnd>& ends);

/// Combines the results at all ends: their verdict where they agree, undecided else; the worst of
/// them is reported. `at_ends` has one result each, empty where it could not be had; `why_not`, a
/// clause, says why if the document is not the cause.
DriveReport judged_at_ends(DriveReport as_asked, const std::vector<HeatEnd>& ends,
                           std::vector<std::optional<DriveReport>> at_ends,
                           const std::string& why_not = "");

}  // namespace torquewright::actuator
