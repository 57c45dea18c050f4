// SPDX-License-Identifier: Apache-2.0
#include "src/commands/planning/hopper_flip_json.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "hopper/planning/search/plan_report_spec.hpp"
#include "src/commands/actuator/check_options_json.hpp"
#include "src/commands/shared/fingerprint_json.hpp"
#include "src/commands/shared/result_json.hpp"
#include "src/sweep/swept_json.hpp"

namespace torquewright::cli {
namespace {

using nlohmann::ordered_json;

void add_margins(const hopper::PlanMargins& margins, ordered_json& json) {
  const hopper::PlanMargins usual;
  const auto add = [&json](const char* key, double value, double unless) {
    if (value != unless) json[key] = value;
  };
  add("voltage_margin", margins.voltage, usual.voltage);
  add("current_margin", margins.current, usual.current);
  add("friction_margin", margins.friction, usual.friction);
  add("center_of_pressure_margin", margins.center_of_pressure, usual.center_of_pressure);
  add("gear_margin", margins.gear_load, usual.gear_load);
  add("position_margin_rad", margins.position_rad, usual.position_rad);
  add("speed_margin", margins.speed, usual.speed);
}

/// What was asked for beyond the files and what the report states itself, where it is not the
/// default.
ordered_json request_json(const HopperFlipRequest& request) {
  const HopperFlipRequest usual;
  const hopper::PlanOptions& plan = request.plan;
  const hopper::ContactRule& contact = request.warm.check.contact;
  ordered_json json =
      check_options_json(request.warm.columns, request.warm.window, request.warm.operating);
  const auto add = [&json](const char* key, const auto& value, const auto& unless) {
    if (value != unless) json[key] = value;
  };
  if (request.rise_m) json["rise_m"] = *request.rise_m;
  if (request.stride_m) json["stride_m"] = *request.stride_m;
  add("contacts", request.contacts, usual.contacts);
  add("objective", request.objectives, usual.objectives);
  add_margins(plan.margins, json);
  add("intervals", plan.intervals, usual.plan.intervals);
  add("integration_error_rad", plan.most_error_rad, usual.plan.most_error_rad);
  add("rounds", plan.most_rounds, usual.plan.most_rounds);
  add("iterations", plan.most_iterations, usual.plan.most_iterations);
  add("time_limit_s", plan.most_seconds, usual.plan.most_seconds);
  add("guess_noise_rad", plan.guess_noise_rad, usual.plan.guess_noise_rad);
  add("seed", request.guess_seed, usual.guess_seed);
  add("sample_step_s", plan.sample_s, usual.plan.sample_s);
  add("load_window_s", request.warm.check.load_window_s, usual.warm.check.load_window_s);
  add("warm", request.warm.trajectory_file, usual.warm.trajectory_file);
  if (contact.height_m) json["contact_height_m"] = *contact.height_m;
  if (contact.speed_m_s) json["contact_speed_m_s"] = *contact.speed_m_s;
  add("explain", plan.explain, usual.plan.explain);
  return json;
}

/// The same of a sweep, whose document states nothing of it elsewhere.
ordered_json sweep_request_json(const HopperFlipRequest& request) {
  ordered_json json{{"task", request.task}, {"limits", request.limits}};
  json.update(request_json(request));
  return json;
}

std::vector<io::Document> read_documents(const HopperFlipInputs& inputs) {
  std::vector<io::Document> read = inputs.robot.documents;
  if (inputs.warm) read.push_back({inputs.warm->file, "", {}, inputs.warm->sha256});
  read.insert(read.end(), inputs.columns.begin(), inputs.columns.end());
  return read;
}

}  // namespace

std::string hopper_flip_json(const HopperFlipRequest& request, const HopperFlipInputs& inputs,
                             const hopper::PlanResult& result) {
  const auto seconds =
      request.timing ? hopper::PlanSeconds::kStated : hopper::PlanSeconds::kLeftOut;
  ordered_json document = hopper::plan_report_json(inputs.plan, result, seconds);
  document["options"] = request_json(request);
  return result_text(std::move(document), read_documents(inputs));
}

std::string hopper_flip_fingerprint(const HopperFlipRequest& request,
                                    const HopperFlipInputs& inputs) {
  return fingerprint("hopper flip", sweep_request_json(request), read_documents(inputs));
}

std::string hopper_flip_sweep_json(const HopperFlipRequest& request, const HopperFlipInputs& inputs,
                                   const sweep::Swept& swept) {
  ordered_json document = sweep::swept_json(swept);
  document["options"] = sweep_request_json(request);
  return result_text(std::move(document), read_documents(inputs));
}

}  // namespace torquewright::cli
