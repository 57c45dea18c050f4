// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "actuator/mor/mor_table.hpp"

namespace torquewright::report {

/// A region to be drawn, and what it is called where there are several.
struct PlottedRegion {
  std::string label;
  actuator::MorTable table;
  bool has_battery = true;  ///< Else what limits the power is the supply's current.
};

}  // namespace torquewright::report
