// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "src/options/operating_options.hpp"
#include "src/options/window_options.hpp"

namespace torquewright::cli {

/// The first "options" of a check's report: columns, window and operating conditions, where they
/// are not the default.
nlohmann::ordered_json check_options_json(const std::vector<std::string>& columns,
                                          const WindowOptions& window,
                                          const OperatingOptions& operating);

}  // namespace torquewright::cli
