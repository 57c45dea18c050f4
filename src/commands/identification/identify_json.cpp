// SPDX-License-Identifier: Apache-2.0
#include "src/commands/identification/identify_json.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "identification/answer/report_spec.hpp"
#include "identification/robot/robot_study_json.hpp"
#include "identification/rollout/simulated_errors_json.hpp"
#include "io/faults/json_text.hpp"
#include "src/commands/shared/moved_references_json.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/commands/shared/stated_json.hpp"

namespace torquewright::cli {

std::string identify_json(const IdentifyRequest& request, const IdentifyInputs& inputs,
                          const identification::Identification& found,
                          const std::optional<report::RobotReport>& robot) {
  nlohmann::ordered_json document = identification::identification_report_json(found);
  if (robot) document["simulated"] = identification::simulated_json(robot->errors);
  if (robot && robot->study) {
    document["simulated"]["after_is_fitted"] = robot->is_fitted;
    identification::add_study(*robot->study, robot->errors.joints, document);
  }
  if (robot && robot->written.robot)
    document["simulated"]["written_robot"] =
        identification::errors_json(robot->written.robot->whole);
  if (robot && robot->written.groups)
    document["simulated"]["written_groups"] =
        identification::errors_json(robot->written.groups->whole);
  if (robot && !robot->disagreements.empty())
    document["simulated"]["disagreements"] = robot->disagreements;
  document["options"] = nlohmann::ordered_json::object();
  if (!request.select) document["options"]["select"] = false;
  document["options"].update(stated_json(*request.declared));
  std::vector<io::Document> read;
  for (const auto& file : found.files) read.push_back({file.path, "", {}, file.sha256});
  read.push_back(inputs.rig_document);
  read.insert(read.end(), inputs.robot_documents.begin(), inputs.robot_documents.end());
  for (const auto& actuator : inputs.actuators) {
    if (!actuator.nominal.documents.front().path.empty()) continue;  // made of the robot's
    read.insert(read.end(), actuator.nominal.documents.begin(), actuator.nominal.documents.end());
  }
  return result_text(std::move(document), read);
}

std::string refined_text(nlohmann::ordered_json document, const std::string& nominal,
                         const std::string& output) {
  if (!output.empty()) move_actuator(document, nominal, output);
  return io::json_text(document, 2);
}

}  // namespace torquewright::cli
