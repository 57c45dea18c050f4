// SPDX-License-Identifier: Apache-2.0
#include "identification/robot/fitted_actuator_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace torquewright::identification {
namespace {

using nlohmann::ordered_json;

ordered_json waves_json(const actuator::Effect& effect) {
  ordered_json waves = ordered_json::array();
  for (const actuator::Harmonic& each : effect.harmonics) {
    waves.push_back({{"order", each.order},
                     {effect.proportional ? "amplitude_ratio" : "amplitude_Nm", each.amplitude},
                     {"phase_rad", each.phase_rad}});
  }
  return waves;
}

ordered_json parameters_json(const actuator::Effect& effect) {
  ordered_json parameters = ordered_json::object();
  for (std::size_t p = 0; p < effect.values.size(); ++p) {
    if (std::isfinite(effect.values[p])) {
      parameters[std::string(effect.kind->parameters[p].name)] = effect.values[p];
    }
  }
  if (effect.kind->has_harmonics) parameters["harmonics"] = waves_json(effect);
  return parameters;
}

bool is_moved_by(const ValueFit& fit, std::size_t joint, const actuator::Effect& effect) {
  return std::any_of(fit.values.begin(), fit.values.end(), [&](const FittedValue& each) {
    return each.which.joint == joint && each.which.effect == effect.kind->name;
  });
}

/// Of the parameters; a wave's are of its two parts, in which it was fitted, and not written.
ordered_json errors_json_of(const ValueFit& fit, std::size_t joint,
                            const actuator::Effect& effect) {
  ordered_json errors = ordered_json::object();
  for (const FittedValue& each : fit.values) {
    const FreeValue& which = each.which;
    if (which.joint != joint || which.effect != effect.kind->name) continue;
    if (which.of != FreeValue::Of::kEffect) continue;
    errors[which.name] = each.is_told() ? ordered_json(each.standard_error) : ordered_json();
  }
  return errors;
}

bool is_nothing(const actuator::Effect& effect) {
  const auto is_zero = [](double each) { return each == 0.0; };
  return std::all_of(effect.values.begin(), effect.values.end(), is_zero) &&
         std::all_of(effect.harmonics.begin(), effect.harmonics.end(),
                     [](const actuator::Harmonic& each) { return each.amplitude == 0.0; });
}

ordered_json rms_of(const RobotErrors& errors, std::size_t joint) {
  const RolloutError& error = judged(errors.whole);
  return joint < error.by_joint_rad.size() ? ordered_json(error.by_joint_rad[joint])
                                           : ordered_json();
}

}  // namespace

ordered_json fitted_actuator(const io::Document& nominal, const RobotStudy& study,
                             std::size_t joint, const std::vector<Log::File>& logs,
                             const SimulatedErrors& errors) {
  ordered_json document = ordered_json::parse(nominal.root.dump());
  ordered_json read = ordered_json::array();
  for (const Log::File& file : logs) read.push_back({{"path", file.path}, {"sha256", file.sha256}});
  const actuator::Actuator& drive = study.fit.model.drives[joint];
  document["motor"]["rotor_inertia_kg_m2"] = drive.motor.rotor_inertia_kg_m2;
  if (!document.contains("effects")) document["effects"] = ordered_json::array();
  ordered_json& effects = document["effects"];
  for (const actuator::Effect& effect : drive.effects) {
    if (!is_moved_by(study.fit, joint, effect)) continue;
    const auto own = std::find_if(effects.begin(), effects.end(), [&](const ordered_json& each) {
      return each.value("effect", "") == effect.kind->name;
    });
    if (own == effects.end() && is_nothing(effect)) continue;
    ordered_json& entry = own == effects.end() ? effects.emplace_back() : *own;
    entry["effect"] = std::string(effect.kind->name);
    entry["parameters"] = parameters_json(effect);
    entry["standard_error"] = errors_json_of(study.fit, joint, effect);
    entry["provenance"] = {{"source", "identified"},
                           {"logs", read},
                           {"holdout_rms_before", rms_of(errors.before, joint)},
                           {"holdout_rms_after", rms_of(errors.after, joint)},
                           {"unit", "rad"}};
  }
  return document;
}

}  // namespace torquewright::identification
