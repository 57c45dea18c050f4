// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "src/report/robot/calibration_text.hpp"

namespace torquewright::report {

/// A document of kind calibration_report without its provenance ("tool", "inputs").
nlohmann::ordered_json calibration_json(const CalibrationReport& report);

}  // namespace torquewright::report
