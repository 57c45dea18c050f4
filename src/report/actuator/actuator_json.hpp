// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "actuator/mor/need.hpp"

namespace torquewright::report {

/// What `actuator mor --need` says: kind mor_need without its provenance.
nlohmann::ordered_json need_json(const actuator::Need& need, const actuator::NeedAnswer& answer);

/// What `actuator mor --ratio` says: kind mor_ratios without its provenance.
nlohmann::ordered_json sweep_json(const std::vector<actuator::RatioRow>& rows);

}  // namespace torquewright::report
