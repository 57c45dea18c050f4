// SPDX-License-Identifier: Apache-2.0
#include "hopper/candidates/candidates_spec.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

namespace torquewright::hopper {
namespace {

using nlohmann::ordered_json;

ordered_json number(const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return nullptr;
  return *value;
}

const char* const kDynamics = "dynamics";
const char* const kExchanged = "file_with_rotors_exchanged";

/// Of all keys but its drives.
ordered_json result_json(const CandidateResult& result) {
  return {{"candidate", result.name},
          {"ratio", result.ratio},
          {"verdict", actuator::name_of(result.verdict)},
          {"margin_share", number(result.margin_share)},
          {"speed_margin_rad_s", number(result.speed_margin_rad_s)},
          {"mass_kg", number(result.mass_kg)},
          {"energy_J", number(result.energy_J)},
          {"copper_loss_J", number(result.copper_loss_J)},
          {"peak_torque_Nm", number(result.peak_torque_Nm)},
          {"rotor_inertia_kg_m2", result.rotor_inertia_kg_m2},
          {"torques", result.torques == CandidateTorques::kDynamics ? kDynamics : kExchanged},
          {"on_pareto_front", result.is_on_front},
          {"why", result.why}};
}

std::optional<double> if_number(const ordered_json& value) {
  if (!value.is_number()) return std::nullopt;
  return value.get<double>();
}

/// What has no number in JSON is without end.
double number_of(const ordered_json& value) {
  return if_number(value).value_or(std::numeric_limits<double>::infinity());
}

}  // namespace

ordered_json candidates_json(const Robot& robot, const std::vector<CandidateResult>& results) {
  ordered_json list = ordered_json::array();
  for (const CandidateResult& result : results) {
    ordered_json keys{{"drives", robot.drivetrains[result.drivetrain].actuator_names}};
    keys.update(result_json(result));
    list.push_back(std::move(keys));
  }
  return list;
}

std::string candidate_text(const CandidateResult& result) {
  ordered_json keys{{"drivetrain", result.drivetrain}};
  keys.update(result_json(result));
  return keys.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

CandidateResult candidate_of(const std::string& text) {
  const ordered_json keys = ordered_json::parse(text);
  CandidateResult result;
  result.drivetrain = keys.at("drivetrain");
  result.name = keys.at("candidate");
  result.ratio = keys.at("ratio");
  for (const actuator::Verdict verdict :
       {actuator::Verdict::kPass, actuator::Verdict::kFail, actuator::Verdict::kUndecided}) {
    if (keys.at("verdict") == actuator::name_of(verdict)) result.verdict = verdict;
  }
  result.margin_share = number_of(keys.at("margin_share"));
  result.speed_margin_rad_s = if_number(keys.at("speed_margin_rad_s"));
  result.mass_kg = if_number(keys.at("mass_kg"));
  result.energy_J = if_number(keys.at("energy_J"));
  result.copper_loss_J = if_number(keys.at("copper_loss_J"));
  result.peak_torque_Nm = number_of(keys.at("peak_torque_Nm"));
  result.rotor_inertia_kg_m2 = keys.at("rotor_inertia_kg_m2");
  result.torques = keys.at("torques") == kDynamics ? CandidateTorques::kDynamics
                                                   : CandidateTorques::kExchangedFile;
  result.is_on_front = keys.at("on_pareto_front");
  result.why = keys.at("why");
  return result;
}

}  // namespace torquewright::hopper
