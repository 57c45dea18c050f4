// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "actuator/region/joint_region.hpp"

namespace torquewright::actuator {

/// What a region's table is of: all that it says besides its rows follows from this.
struct MorHeader {
  const Actuator* actuator = nullptr;
  OperatingConditions conditions;
  Side side = Side::kJoint;
};

std::string_view name_of(Side side);
std::string_view name_of(Rating rating);

/// What stands between the rotor's torque and the table's, in words.
std::string friction_sentence(const MorHeader& header);

}  // namespace torquewright::actuator
