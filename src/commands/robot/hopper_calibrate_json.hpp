// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "io/documents/document.hpp"
#include "src/options/calibration_request.hpp"
#include "src/report/robot/calibration_text.hpp"

namespace torquewright::cli {

/// A posture of the command line.
struct StatedPosture {
  std::string name;
  std::map<std::string, double> positions;  ///< By joint, in rad or m.
};

/// Writes it into a robot's document, over one of that name.
void add_posture(const StatedPosture& posture, nlohmann::json& robot);

/// The report as a document of kind calibration_report.
std::string calibration_result(const CalibrationRequest& request,
                               const std::vector<io::Document>& inputs,
                               const report::CalibrationReport& report);

/// The robot's document with the fitted values, which stay assumed. Requires a best fit.
std::string calibrated_robot(const CalibrationRequest& request, const io::Document& robot,
                             const report::CalibrationReport& report);

}  // namespace torquewright::cli
