// SPDX-License-Identifier: Apache-2.0
#include "src/commands/robot/hopper_replay_json.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "hopper/replay/replay_report_spec.hpp"
#include "src/commands/actuator/check_options_json.hpp"
#include "src/commands/shared/fingerprint_json.hpp"
#include "src/commands/shared/result_json.hpp"

namespace torquewright::cli {
namespace {

/// What was asked for beyond the files and what the report states itself, where it is not the
/// default.
nlohmann::ordered_json request_json(const HopperReplayRequest& request) {
  const HopperReplayRequest usual;
  const hopper::ContactRule& contact = request.motion.check.contact;
  nlohmann::ordered_json json =
      check_options_json(request.motion.columns, request.motion.window, request.motion.operating);
  const auto add = [&json](const char* key, const auto& value, const auto& default_value) {
    if (value != default_value) json[key] = value;
  };
  add("torques", request.motion.torques, usual.motion.torques);
  add("late_columns", request.motion.late_columns, usual.motion.late_columns);
  add("ground_height_m", contact.ground_height_m, usual.motion.check.contact.ground_height_m);
  if (contact.height_m) json["contact_height_m"] = *contact.height_m;
  if (contact.speed_m_s) json["contact_speed_m_s"] = *contact.speed_m_s;
  add("load_window_s", request.motion.check.load_window_s, usual.motion.check.load_window_s);
  add("impact_metric", request.impact_metric, usual.impact_metric);
  add("impact_contact", request.impact_contact, usual.impact_contact);
  add("fixed_clock", request.fixed_clock, usual.fixed_clock);
  add("impact_window_s", request.impact_window_s, usual.impact_window_s);
  add("impact_blend_s", request.impact_blend_s, usual.impact_blend_s);
  add("stand_s", request.stand_s, usual.stand_s);
  add("ground_rise_m", request.ground_rise_m, usual.ground_rise_m);
  add("push", request.pushes, usual.pushes);
  add("trials", request.trials, usual.trials);
  if (request.only_trial >= 0) json["trial"] = request.only_trial;
  add("flight_tolerance", request.deeds.share, usual.deeds.share);
  add("place_tolerance_m", request.deeds.place_m, usual.deeds.place_m);
  add("rotation_tolerance_rad", request.deeds.turn_rad, usual.deeds.turn_rad);
  add("joint_tolerance_rad", request.deeds.joint_rad, usual.deeds.joint_rad);
  add("slide_tolerance_m", request.deeds.slide_m, usual.deeds.slide_m);
  add("no_filter", request.without_filter, usual.without_filter);
  add("ground_time_constant_s", request.contact_time_constant_s, usual.contact_time_constant_s);
  return json;
}

std::vector<io::Document> read_documents(const HopperCheckInputs& inputs,
                                         const hopper::Motion& motion) {
  std::vector<io::Document> read = inputs.robot.documents;
  read.push_back({motion.file, "", {}, motion.sha256});
  read.insert(read.end(), inputs.columns.begin(), inputs.columns.end());
  return read;
}

}  // namespace

std::string hopper_replay_json(const HopperReplayRequest& request, const HopperCheckInputs& inputs,
                               const hopper::Motion& motion, const hopper::ReplayReport& report) {
  nlohmann::ordered_json document = hopper::replay_report_json(report);
  document["options"] = request_json(request);
  return result_text(std::move(document), read_documents(inputs, motion));
}

std::string hopper_trials_fingerprint(const HopperReplayRequest& request,
                                      const HopperCheckInputs& inputs,
                                      const hopper::Motion& motion) {
  nlohmann::ordered_json options = request_json(request);
  for (const char* key : {"trials", "trial"}) options.erase(key);
  options["engine"] = request.engine;
  options["limits"] = request.limits;
  options["controller"] = request.controller;
  options["impact"] = request.impact;
  options["step_s"] = request.step_s;
  options["control_period_s"] = request.control_period_s;
  options["latency_s"] = request.latency_s;
  options["seed"] = request.seed;
  return fingerprint("hopper replay", options, read_documents(inputs, motion));
}

}  // namespace torquewright::cli
