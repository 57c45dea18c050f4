// SPDX-License-Identifier: Apache-2.0
#include "src/commands/robot/hopper_calibrate_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/faults/json_text.hpp"
#include "src/commands/shared/moved_references_json.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/commands/shared/stated_json.hpp"
#include "src/report/robot/calibration_json.hpp"

namespace torquewright::cli {

void add_posture(const StatedPosture& posture, nlohmann::json& robot) {
  robot["postures"][posture.name] = posture.positions;
}

std::string calibration_result(const CalibrationRequest& request,
                               const std::vector<io::Document>& inputs,
                               const report::CalibrationReport& report) {
  nlohmann::ordered_json result = report::calibration_json(report);
  result["options"] = stated_json(*request.declared);
  return result_text(std::move(result), inputs);
}

std::string calibrated_robot(const CalibrationRequest& request, const io::Document& robot,
                             const report::CalibrationReport& report) {
  nlohmann::json root = robot.root;
  nlohmann::json& assumed = root["assumed"];
  if (assumed.is_null()) assumed = nlohmann::json::array();
  const auto assume = [&assumed](const std::string& pointer) {
    if (std::find(assumed.begin(), assumed.end(), pointer) == assumed.end()) {
      assumed.push_back(pointer);
    }
  };
  for (const std::string& posture : request.postures) {
    assume(io::child_path("/postures", posture.substr(0, posture.find('='))));
  }
  const auto& free = report.question.free;
  for (std::size_t i = 0; i < free.size(); ++i) {
    for (const std::string& pointer : free[i].pointers) {
      root[nlohmann::json::json_pointer(pointer)] = report.found.best->values[i];
      assume(pointer);
      root["provenance"].push_back(report::calibration_provenance(report, i, pointer));
    }
  }
  move_robot(root, robot.file, request.refined_file);
  return io::json_text(root);
}

}  // namespace torquewright::cli
