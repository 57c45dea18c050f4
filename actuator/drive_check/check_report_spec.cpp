// SPDX-License-Identifier: Apache-2.0
#include "actuator/drive_check/check_report_spec.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace torquewright::actuator {
namespace {

using nlohmann::ordered_json;

ordered_json number(std::optional<double> value) {
  if (!value || !std::isfinite(*value)) return {};
  return *value == 0.0 ? 0.0 : *value;  // not -0
}

ordered_json count(std::optional<std::size_t> value) {
  return value ? ordered_json(*value) : ordered_json();
}

double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

ordered_json worst_json(const WorstSample& worst) {
  return {{"time_s", worst.time_s},
          {"speed_rad_s", number(worst.speed_rad_s)},
          {"torque_Nm", number(worst.torque_Nm)},
          {"limit_Nm", number(worst.limit_Nm)},
          {"excess_Nm", worst.excess_Nm},
          {"limiter", name_of(worst.limiter)}};
}

ordered_json winding_json(const WindingReport& winding) {
  return {{"limit_K", winding.limit_K},
          {"runs", winding.runs},
          {"first_run_peak_K", number(winding.first_peak_K)},
          {"peak_K", number(winding.peak_K)},
          {"end_K", number(winding.end_K)},
          {"steady_peak_K", number(winding.steady_peak_K)},
          {"runs_to_steady", count(winding.runs_to_steady)},
          {"runs_to_limit", count(winding.runs_to_limit)},
          {"resolution_s", winding.resolution_s}};
}

/// Null of a drive that is known by its curve alone.
ordered_json known(const CheckedInterpretation& interpretation, double value) {
  return interpretation.has_winding ? ordered_json(value) : ordered_json();
}

/// With a limit of null there is no verdict on it.
ordered_json continuous_json(const CheckedInterpretation& interpretation) {
  const ContinuousUse& current = interpretation.continuous_current;
  ordered_json entry{{"rms_current_A", known(interpretation, current.rms)},
                     {"limit_A", number(current.limit)},
                     {"margin_A", number(current.margin())}};
  const ContinuousUse& torque = interpretation.continuous_torque;
  if (!torque.limit) return entry;
  entry["side"] = interpretation.is_rated_at_joint ? "joint" : "motor";
  entry["rms_torque_Nm"] = torque.rms;
  entry["limit_Nm"] = number(torque.limit);
  entry["margin_Nm"] = number(torque.margin());
  return entry;
}

/// The keys of an interpretation, which are a joint's own, too.
void add_interpretation(const CheckedInterpretation& interpretation, std::size_t samples,
                        ordered_json& entry) {
  entry["clipped_samples"] = interpretation.clipped_samples;
  entry["clipped_share"] = share(interpretation.clipped_samples, samples);
  entry["clipped_time_s"] = interpretation.clipped_time_s;
  entry["worst"] = worst_json(interpretation.worst);
  entry["margin_Nm"] = number(interpretation.margin_Nm);
  entry["speed_margin_rad_s"] = number(interpretation.speed_margin_rad_s);
  entry["voltage_margin_V"] = number(interpretation.voltage_margin_V);
  entry["peak_torque_Nm"] = interpretation.peak_torque_Nm;
  entry["rms_torque_Nm"] = interpretation.rms_torque_Nm;
  entry["peak_current_A"] = known(interpretation, interpretation.peak_current_A);
  entry["rms_current_A"] = known(interpretation, interpretation.rms_current_A);
  entry["continuous"] = continuous_json(interpretation);
  entry["energy_drawn_J"] = known(interpretation, interpretation.energy_drawn_J);
  entry["energy_returned_J"] = known(interpretation, interpretation.energy_returned_J);
  entry["winding"] =
      interpretation.winding ? winding_json(*interpretation.winding) : ordered_json();
}

/// A joint without torque has the same keys, with what cannot be told null.
void add_unknown_interpretation(const DriveReport& drive, ordered_json& entry) {
  const bool is_impossible = drive.impossible_speeds > 0;
  entry["clipped_samples"] = is_impossible ? ordered_json(drive.impossible_speeds) : ordered_json();
  entry["clipped_share"] =
      is_impossible ? ordered_json(share(drive.impossible_speeds, drive.samples)) : ordered_json();
  for (const char* key :
       {"clipped_time_s", "worst", "margin_Nm", "speed_margin_rad_s", "voltage_margin_V",
        "peak_torque_Nm", "rms_torque_Nm", "peak_current_A", "rms_current_A", "continuous",
        "energy_drawn_J", "energy_returned_J", "winding"}) {
    entry[key] = nullptr;
  }
}

ordered_json interpretation_json(const CheckedInterpretation& interpretation, std::size_t samples,
                                 bool includes_inertia) {
  ordered_json entry{{"torque_includes_inertia", includes_inertia},
                     {"verdict", fails(interpretation) ? "fail" : "pass"}};
  add_interpretation(interpretation, samples, entry);
  return entry;
}

ordered_json inertia_json(const DriveReport& drive) {
  switch (drive.inertia) {
    case InertiaConvention::kIncluded:
      return true;
    case InertiaConvention::kExcluded:
      return false;
    case InertiaConvention::kUnstated:
      break;
  }
  return nullptr;
}

ordered_json left_out_json(const DriveReport& drive) {
  ordered_json effects = ordered_json::array();
  for (const LeftOutEffect& effect : drive.effects_left_out) {
    effects.push_back({{"effect", effect.effect}, {"misjudged_Nm", number(effect.misjudged_Nm)}});
  }
  return effects;
}

ordered_json joint_json(const DriveReport& drive) {
  ordered_json entry{
      {"name", drive.name},       {"actuator", drive.actuator}, {"verdict", name_of(drive.verdict)},
      {"samples", drive.samples}, {"from_s", drive.from_s},     {"until_s", drive.until_s}};
  if (drive.has_torque) {
    add_interpretation(drive.interpretation, drive.samples, entry);
  } else {
    add_unknown_interpretation(drive, entry);
  }
  entry["peak_speed_rad_s"] = drive.peak_speed_rad_s;
  entry["no_load_speed_rad_s"] = number(drive.no_load_speed_rad_s);
  entry["armature_kg_m2"] = drive.armature_kg_m2;
  entry["torque_includes_inertia"] = inertia_json(drive);
  if (drive.with_inertia) {
    entry["readings"] = {interpretation_json(drive.interpretation, drive.samples, true),
                         interpretation_json(*drive.with_inertia, drive.samples, false)};
  }
  entry["velocity_differentiated"] = drive.is_speed_differentiated;
  entry["left_out"] = drive.left_out;
  if (!drive.effects_left_out.empty()) entry["effects_left_out"] = left_out_json(drive);
  entry["assumed"] = drive.assumed;
  return entry;
}

}  // namespace

ordered_json finding_json(const Finding& finding) {
  return {{"severity", name_of(finding.severity)},
          {"rule", finding.rule},
          {"joint", finding.joint.empty() ? ordered_json() : ordered_json(finding.joint)},
          {"time_s", number(finding.time_s)},
          {"value", number(finding.value)},
          {"limit", number(finding.limit)},
          {"unit", finding.unit},
          {"sentence", finding.sentence}};
}

ordered_json check_report_json(const CheckReport& report) {
  ordered_json joints = ordered_json::array();
  for (const DriveReport& drive : report.drives) joints.push_back(joint_json(drive));
  ordered_json findings = ordered_json::array();
  for (const Finding& finding : report.findings) findings.push_back(finding_json(finding));
  return {{"kind", "check_report"},
          {"version", 1},
          {"verdict", name_of(report.verdict)},
          {"joints", joints},
          {"findings", findings}};
}

}  // namespace torquewright::actuator
