// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "actuator/catalogue/drive_set.hpp"
#include "actuator/catalogue/shortlist.hpp"

namespace torquewright::report {

/// One drive of a set and how it does.
struct RankedDrive {
  const actuator::NamedActuator* drive = nullptr;
  actuator::Suitability suitability;
};

/// `actuator find` as a table: those that fit by their margin, then the others with the reason.
std::string shortlist_text(const std::vector<RankedDrive>& drives,
                           const std::vector<std::string>& left_out);

}  // namespace torquewright::report
