// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "actuator/mor/need.hpp"

namespace torquewright::report {

/// What `actuator mor --need` says: reached or not, by how much, and what
/// alone would do.
std::string need_text(const actuator::Actuator& actuator, const actuator::Need& need,
                      const actuator::NeedAnswer& answer);

/// What `actuator mor --ratio` says: a row for each ratio.
std::string sweep_text(const std::vector<actuator::RatioRow>& rows);

}  // namespace torquewright::report
