// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "actuator/check/drive_check.hpp"

namespace torquewright::actuator {

/// One end of the temperatures of a winding in the last run of a motion, at which the drive is
/// judged too.
struct HeatEnd {
  double winding_K = 0.0;
  bool is_as_asked = false;        ///< Within kSteady_K: what is known already holds.
  OperatingConditions conditions;  ///< As asked for, with the winding so warm.
  std::string objection;           ///< Why the document does not reach there; empty: it does.

  bool is_to_be_judged() const { return !is_as_asked && objection.empty(); }
};

/// The coldest, and of several runs the warmest: a single one is judged by what it begins with.
/// Empty where the temperature was stated or is not known, and where it has no bound.
std::vector<HeatEnd> heat_ends(const CheckedDrive& drive, const DriveReport& as_asked);

/// Whether the drive has yet to be judged elsewhere than as asked for.
bool need_judging(const DriveReport& as_asked, const std::vector<HeatEnd>& ends);

/// What holds at all ends: their verdict where they agree, undecided else. The worst of them is
/// what is reported. `at_ends`: one each, empty where it was not to be had; `why_not`, a clause,
/// says why if the document is not the cause.
DriveReport judged_at_ends(DriveReport as_asked, const std::vector<HeatEnd>& ends,
                           std::vector<std::optional<DriveReport>> at_ends,
                           const std::string& why_not = "");

}  // namespace torquewright::actuator
