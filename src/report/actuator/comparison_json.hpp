// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "actuator/mor/region_comparison.hpp"
#include "actuator/region/joint_region.hpp"

namespace torquewright::report {

/// Two regions side by side: a document of kind `region_comparison` without its provenance.
nlohmann::ordered_json comparison_json(const std::string& from, const std::string& to,
                                       const actuator::RegionComparison& comparison,
                                       actuator::Side side);

}  // namespace torquewright::report
