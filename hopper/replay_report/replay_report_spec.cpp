// SPDX-License-Identifier: Apache-2.0
#include "hopper/replay_report/replay_report_spec.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "actuator/drive_check/check_report_spec.hpp"
#include "hopper/check/hopper_report_spec.hpp"

namespace torquewright::hopper {
namespace {

using nlohmann::ordered_json;

ordered_json landing_json(const TouchDown& down) {
  return {{"time_s", down.time_s},
          {"planned_s", down.planned_s},
          {"rotation_short_rad", down.rotation_short_rad}};
}

ordered_json touch_down_json(const ReplayOutcome& outcome) {
  return outcome.touch_down ? landing_json(*outcome.touch_down) : ordered_json();
}

ordered_json landings_json(const ReplayOutcome& outcome) {
  ordered_json list = ordered_json::array();
  for (const TouchDown& down : outcome.landings) list.push_back(landing_json(down));
  return list;
}

ordered_json deeds_json(const std::vector<Deed>& deeds) {
  ordered_json list = ordered_json::array();
  for (const Deed& deed : deeds) {
    list.push_back({{"deed", deed.name},
                    {"of", deed.of},
                    {"planned", deed.planned},
                    {"done", deed.done},
                    {"off", deed.off},
                    {"tolerance", deed.tolerance},
                    {"unit", deed.unit},
                    {"is_done", deed.is_done}});
  }
  return list;
}

ordered_json touch_down_load_json(const ReplayResult& result) {
  if (!result.touch_down_load) return nullptr;
  const TouchDownLoad& load = *result.touch_down_load;
  const Eigen::Vector3d& impulse = load.impulse_N_s;
  return {{"window_s", load.window_s},
          {"impulse_N_s", {impulse.x(), impulse.y(), impulse.z()}},
          {"force_window_s", load.force_window_s},
          {"peak_force_N", load.peak_force_N}};
}

ordered_json drives_json(const std::vector<DriveReplay>& drives) {
  ordered_json list = ordered_json::array();
  for (const DriveReplay& drive : drives) {
    list.push_back({{"name", drive.name},
                    {"clipped_share", drive.clipped_share},
                    {"peak_cut_off_Nm", drive.peak_cut_off_Nm},
                    {"peak_torque_Nm", drive.peak_torque_Nm},
                    {"peak_tracking_error_rad", drive.peak_tracking_error_rad}});
    if (drive.moves_slide) list.back()["moves_slide"] = true;
  }
  return list;
}

ordered_json heat_json(const std::vector<DriveReplay>& drives) {
  ordered_json list = ordered_json::array();
  for (const DriveReplay& drive : drives) {
    if (!drive.peak_winding_K) continue;
    list.push_back({{"drive", drive.name},
                    {"peak_K", *drive.peak_winding_K},
                    {"limit_K", *drive.winding_limit_K}});
  }
  return list;
}

ordered_json account_json(const ControlAccount& account) {
  ordered_json list = ordered_json::array();
  for (const TaskAccount& task : account.tasks) {
    list.push_back({{"task", task.task},
                    {"unit", task.unit},
                    {"rms", task.rms},
                    {"worst", task.worst},
                    {"worst_time_s", task.worst_s}});
  }
  return {{"looks", account.looks}, {"unsolved", account.unsolved}, {"tasks", list}};
}

ordered_json findings_json(const std::vector<Finding>& findings) {
  ordered_json list = ordered_json::array();
  for (const Finding& finding : findings) list.push_back(actuator::finding_json(finding));
  return list;
}

ordered_json sweep_json(const std::vector<SweptStep>& sweep) {
  ordered_json list = ordered_json::array();
  for (const SweptStep& one : sweep) {
    list.push_back({{"step_s", one.step_s},
                    {"verdict", name_of(one.result.outcome.verdict)},
                    {"touch_down", touch_down_json(one.result.outcome)},
                    {"touch_down_load", touch_down_load_json(one.result)},
                    {"transmission_load", transmission_load_json(one.result.transmission_loads)},
                    {"contact_load", contact_load_json(one.result.contact_loads)}});
  }
  return list;
}

template <typename Value>
ordered_json or_null(const std::optional<Value>& value) {
  return value ? ordered_json(*value) : ordered_json();
}

/// Of all keys but its number.
ordered_json outcome_json(const TrialOutcome& outcome) {
  return {{"verdict", name_of(outcome.verdict)},
          {"end_s", outcome.end_time_s},
          {"reason", outcome.reason},
          {"touch_down_s", or_null(outcome.touch_down_time_s)},
          {"rotation_short_rad", or_null(outcome.rotation_short_rad)},
          {"transmission_load_Nm", outcome.peak_transmission_Nm}};
}

ordered_json trial_json(std::size_t number, const TrialOutcome& outcome) {
  ordered_json keys = {{"number", number}};
  keys.update(outcome_json(outcome));
  return keys;
}

std::optional<double> number_or_none(const ordered_json& value) {
  if (!value.is_number()) return std::nullopt;
  return value.get<double>();
}

ordered_json causes_json(const std::vector<CauseEffect>& causes) {
  ordered_json list = ordered_json::array();
  for (const CauseEffect& effect : causes) {
    const auto& rotation = effect.rotation;
    list.push_back(
        {{"cause", effect.cause},
         {"count", effect.counts.done()},
         {"succeeded", effect.counts.succeeded},
         {"unfinished", effect.counts.unfinished},
         {"landed", rotation ? rotation->landed : 0},
         {"rotation_short_rad", rotation ? ordered_json(rotation->mean_rad) : nullptr},
         {"rotation_deviation_rad", rotation ? ordered_json(rotation->deviation_rad) : nullptr},
         {"variance_share", or_null(effect.variance_share)}});
  }
  return list;
}

ordered_json trials_json(const ReplayTrials& trials) {
  const TrialCounts counts = trials.counts();
  const ShareInterval interval = success_interval(counts);
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < trials.outcomes.size(); ++i) {
    if (trials.outcomes[i]) list.push_back(trial_json(trials.first + i, *trials.outcomes[i]));
  }
  ordered_json keys = {{"count", counts.done()},
                       {"succeeded", counts.succeeded},
                       {"interval", {interval.least, interval.greatest}},
                       {"unfinished", counts.unfinished},
                       {"required_share", trials.required_share},
                       {"seed", trials.seed},
                       {"list", list}};
  if (!trials.causes.empty()) keys["causes"] = causes_json(trials.causes);
  return keys;
}

}  // namespace

std::string trial_text(const TrialOutcome& outcome) {
  return outcome_json(outcome).dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

TrialOutcome trial_of(const std::string& text) {
  const ordered_json keys = ordered_json::parse(text);
  TrialOutcome outcome;
  outcome.verdict = verdict_named(keys.at("verdict").get<std::string>());
  outcome.reason = keys.at("reason");
  outcome.end_time_s = keys.at("end_s");
  outcome.touch_down_time_s = number_or_none(keys.at("touch_down_s"));
  outcome.rotation_short_rad = number_or_none(keys.at("rotation_short_rad"));
  for (const ordered_json& load : keys.at("transmission_load_Nm")) {
    outcome.peak_transmission_Nm.push_back(
        number_or_none(load).value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  return outcome;
}

ordered_json replay_report_json(const ReplayReport& report) {
  const ReplayOptions& options = report.options;
  const ReplayResult& result = report.result;
  const ReplayOutcome& outcome = result.outcome;
  ordered_json document = {
      {"kind", "replay_report"},
      {"version", 1},
      {"verdict", name_of(outcome.verdict)},
      {"engine", options.engine->name},
      {"limits", name_of(options.limits)},
      {"impact", name_of(options.impact.handling)},
      {"controller", options.controller->name},
      {"step_s", options.run.step_s},
      {"control_period_s", options.run.step_s * options.run.steps_per_control},
      {"latency_s", options.run.step_s * options.run.latency_steps},
      {"touch_down", touch_down_json(outcome)},
      {"landings", landings_json(outcome)},
      {"deeds", deeds_json(outcome.deeds)},
      {"end",
       {{"time_s", outcome.end_s},
        {"foot_at_rest_s", outcome.foot_at_rest_s},
        {"reason", outcome.reason}}},
      {"joints", drives_json(result.drives)},
      {"transmission_load", transmission_load_json(result.transmission_loads)},
      {"contact_load", contact_load_json(result.contact_loads)},
      {"touch_down_load", touch_down_load_json(result)},
      {"heat", heat_json(result.drives)},
      {"bus",
       {{"least_V", result.least_bus_V ? ordered_json(*result.least_bus_V) : ordered_json()},
        {"least_time_s", result.least_bus_s},
        {"greatest_power_W", result.greatest_power_W}}},
      {"findings", findings_json(result.findings)}};
  if (!result.account.tasks.empty()) document["tasks"] = account_json(result.account);
  if (!report.sweep.empty()) document["step_sweep"] = sweep_json(report.sweep);
  if (report.trials) document["trials"] = trials_json(*report.trials);
  return document;
}

}  // namespace torquewright::hopper
