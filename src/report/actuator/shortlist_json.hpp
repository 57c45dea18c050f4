// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "src/report/actuator/shortlist.hpp"

namespace torquewright::report {

/// What `actuator find` says as a document of kind drive_shortlist.
nlohmann::ordered_json shortlist_json(const actuator::Wanted& wanted,
                                      const std::vector<RankedDrive>& drives,
                                      const std::vector<std::string>& left_out);

}  // namespace torquewright::report
