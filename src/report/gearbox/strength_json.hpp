// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "src/report/gearbox/strength_text.hpp"

namespace torquewright::report {

/// A document of kind strength_report without its provenance ("tool", "inputs").
nlohmann::ordered_json strength_json(const StrengthReport& report);

}  // namespace torquewright::report
