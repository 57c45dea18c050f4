// SPDX-License-Identifier: Apache-2.0
#include "src/options/identify_request.hpp"

#include <utility>

#include "io/faults/refusal.hpp"

namespace torquewright::cli {

void add_log_options(command_line::Command& command, IdentifyRequest& request) {
  request.declared = &command.declared();
  command.add_option("logs", request.logs, "CSV files of one rig, with a header")
      .needed_by_its_work();
  command
      .add_option("--rig", request.rig_file,
                  "Document of kind rig, which says what the columns are")
      .needed_by_its_work();
  command
      .add_option("--robot", request.robot_file,
                  "Document of kind robot, whose joints moved while its base was held, where the "
                  "rig states no load")
      .otherwise("the rig's load");
  command
      .add_option("--actuator", request.actuators,
                  "Document of kind actuator, as designed; JOINT=FILE, once for each, on a serial "
                  "arm; on a robot only for drives that differ from its document's, '*_knee=FILE' "
                  "for many")
      .needed_by_its_work()
      .one_value_each();
  command.add_flag("--json", request.json, "Print the report as JSON");
}

IdentifyRequest with_refined(IdentifyRequest request) {
  const bool is_printed = request.outputs == std::vector<std::string>{"-"};
  if (request.select && request.refined.empty() && !request.outputs.empty() && !is_printed) {
    std::swap(request.refined, request.outputs);
    request.is_old_spelling = true;
  }
  if (request.outputs.size() > 1) io::refuse("--output", "there is one report, for one file");
  if (is_printed && !request.as.empty()) {
    io::refuse("--as", "standard output takes the report of -o -");
  }
  return request;
}

std::string report_document(const IdentifyRequest& request) {
  return request.outputs.empty() ? std::string() : request.outputs.front();
}

void require_log_options(const IdentifyRequest& request) {
  if (request.logs.empty()) command_line::refuse("logs is required");
  if (request.rig_file.empty())
    command_line::refuse(
        "--rig is required; `torquewright init rig --from LOG -o rig.json` drafts one");
}

}  // namespace torquewright::cli
