// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "gearbox/strength/strength_spec.hpp"
#include "gearbox/strength/strength_table.hpp"
#include "gearbox/strength/torque_limit.hpp"

namespace torquewright::report {

/// What `gearbox strength` was asked and what it found.
struct StrengthReport {
  gearbox::ReadStrength read;
  gearbox::TorqueSide side = gearbox::TorqueSide::kMotor;
  std::vector<double> torques_Nm;      ///< On that side.
  gearbox::StrengthVariants variants;  ///< Other sizes; empty where none were asked for.

  /// Do the gears of the document bear every torque with the demanded safeties?
  bool passes() const;
};

std::string strength_text(const StrengthReport& report);

}  // namespace torquewright::report
