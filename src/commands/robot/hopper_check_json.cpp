// SPDX-License-Identifier: Apache-2.0
#include "src/commands/robot/hopper_check_json.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "hopper/candidates/candidates_spec.hpp"
#include "hopper/check/hopper_report_spec.hpp"
#include "src/commands/actuator/check_options_json.hpp"
#include "src/commands/shared/fingerprint_json.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/sweep/swept_json.hpp"

namespace torquewright::cli {
namespace {

/// What was asked for beyond the files, where it is not the default.
nlohmann::ordered_json request_json(const HopperCheckRequest& request) {
  const hopper::CheckOptions defaults;
  const hopper::ContactRule& contact = request.check.contact;
  nlohmann::ordered_json json =
      check_options_json(request.columns, request.window, request.operating);
  const auto add = [&json](const char* key, const auto& value, const auto& usual) {
    if (value != usual) json[key] = value;
  };
  add("torques", request.torques, std::string("best"));
  add("late_columns", request.late_columns, std::string("find"));
  add("ground_height_m", request.check.contact.ground_height_m, defaults.contact.ground_height_m);
  if (contact.height_m) json["contact_height_m"] = *contact.height_m;
  if (contact.speed_m_s) json["contact_speed_m_s"] = *contact.speed_m_s;
  add("contact_time_constant_s", contact.time_constant_s, defaults.contact.time_constant_s);
  add("residual_limit", request.check.residual_share, defaults.residual_share);
  add("left_out_share", request.check.left_out_share, defaults.left_out_share);
  add("load_window_s", request.check.load_window_s, defaults.load_window_s);
  add("repeat", request.check.runs, defaults.runs);
  add("ratios", request.ratios, std::string());
  add("pause_s", request.check.pause_s, defaults.pause_s);
  return json;
}

std::vector<io::Document> read_documents(const HopperCheckInputs& inputs,
                                         const HopperCheckRequest& request,
                                         const std::string& motion_sha256) {
  std::vector<io::Document> read = inputs.robot.documents;
  read.push_back({request.trajectory_file, "", {}, motion_sha256});
  read.insert(read.end(), inputs.columns.begin(), inputs.columns.end());
  read.insert(read.end(), inputs.candidates.documents.begin(), inputs.candidates.documents.end());
  return read;
}

}  // namespace

std::string hopper_check_json(const HopperCheckRequest& request, const HopperCheckInputs& inputs,
                              const HopperCheckFound& found) {
  nlohmann::ordered_json document = hopper::hopper_report_json(found.report);
  document["candidates"] = hopper::candidates_json(inputs.robot.robot, found.candidates);
  document["options"] = request_json(request);
  return result_text(std::move(document),
                     read_documents(inputs, request, found.report.check.sha256));
}

std::string hopper_check_fingerprint(const HopperCheckRequest& request,
                                     const HopperCheckInputs& inputs,
                                     const hopper::Motion& motion) {
  return fingerprint("hopper check", request_json(request),
                     read_documents(inputs, request, motion.sha256));
}

std::string hopper_check_sweep_json(const HopperCheckRequest& request,
                                    const HopperCheckInputs& inputs, const hopper::Motion& motion,
                                    const sweep::Swept& swept) {
  nlohmann::ordered_json document = sweep::swept_json(swept);
  document["options"] = request_json(request);
  return result_text(std::move(document), read_documents(inputs, request, motion.sha256));
}

}  // namespace torquewright::cli
