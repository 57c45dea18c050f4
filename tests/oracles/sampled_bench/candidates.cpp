// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/sampled_bench/candidates.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::oracles::sampled {
namespace {

bool contains(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void append(Names& names, const Names& more) {
  names.insert(names.end(), more.begin(), more.end());
}

/// Effects that good data tell apart only from those of other groups.
const std::vector<Names>& groups() {
  static const std::vector<Names> kGroups{
      {"coulomb_friction", "stribeck_friction", "asymmetric_friction", "presliding_friction",
       "position_dependent_friction", "friction_temperature"},
      {"viscous_friction", "quadratic_drag", "asymmetric_friction", "friction_temperature"},
      {"asymmetric_friction", "torque_offset", "current_offset"},
      {"torque_constant_error", "torque_constant_saturation", "torque_constant_temperature",
       "load_dependent_friction", "winding_resistance_temperature"},
      {"torque_constant_error", "load_inertia_error", "load_mass_error", "reflected_inertia"},
      {"torque_lag", "channel_delay", "reflected_inertia", "load_inertia_error",
       "torsional_compliance", "backlash", "presliding_friction"},
      {"cogging_torque", "gear_ripple", "gravity_imbalance", "position_dependent_friction",
       "load_mass_error"},
      {"inverter_dead_time", "coulomb_friction", "torque_constant_saturation",
       "load_dependent_friction", "stribeck_friction"}};
  return kGroups;
}

/// Offset, dry friction of either direction: one constant. A difference of slopes is no constant.
bool is_level_difference(const Effect& effect) {
  return effect.name == "asymmetric_friction" &&
         effect.parameters.at("viscous_positive_Nm_s_rad") ==
             effect.parameters.at("viscous_negative_Nm_s_rad");
}

}  // namespace

Names candidates(const Plant& plant) {
  Names names{"viscous_friction",
              "coulomb_friction",
              "stribeck_friction",
              "asymmetric_friction",
              "quadratic_drag",
              "load_dependent_friction",
              "presliding_friction",
              "torque_constant_saturation",
              "torque_constant_temperature",
              "friction_temperature",
              "cogging_torque",
              "gear_ripple",
              "position_dependent_friction",
              "reflected_inertia",
              "torque_constant_error",
              "velocity_mismatch"};
  if (plant.load.kind != LoadKind::kLinearAxis) append(names, {"backlash", "torsional_compliance"});
  if (!plant.is_voltage_driven()) append(names, {"torque_lag"});
  if (plant.drive == DriveKind::kCurrent) {
    append(names, {"current_offset", "channel_delay", "voltage_sag"});
  }
  if (plant.is_voltage_driven()) {
    append(names, {"winding_resistance_temperature", "inverter_dead_time"});
  }
  if (plant.load.is_dynamometer()) append(names, {"torque_offset"});
  const LoadKind kind = plant.load.kind;
  if (kind == LoadKind::kFree || kind == LoadKind::kImposedSpeed)
    names.push_back("gravity_imbalance");
  if (kind == LoadKind::kFree) names.push_back("load_inertia_error");
  if (kind == LoadKind::kPendulum) append(names, {"load_mass_error", "gravity_imbalance"});
  return names;
}

Needs needs_of(const std::string& effect) {
  Needs needs;
  needs.both_encoders = effect == "backlash" || effect == "torsional_compliance";
  needs.velocity = effect == "velocity_mismatch";
  needs.temperature = effect == "torque_constant_temperature" || effect == "friction_temperature" ||
                      effect == "winding_resistance_temperature";
  needs.bus = effect == "voltage_sag";
  return needs;
}

bool are_separable(const std::string& one, const std::string& other) {
  return one != other && std::none_of(groups().begin(), groups().end(), [&](const Names& group) {
           return contains(group, one) && contains(group, other);
         });
}

Names equals_of(const Effect& effect, const Plant& plant) {
  const std::string& name = effect.name;
  Names names{name};
  const LoadKind kind = plant.load.kind;
  const bool sensorless = !plant.load.is_dynamometer();
  if (name == "torque_offset" || name == "current_offset" || is_level_difference(effect)) {
    for (const char* same : {"torque_offset", "current_offset", "asymmetric_friction"}) {
      if (name != same) names.emplace_back(same);
    }
  }
  if (sensorless && (name == "reflected_inertia" || name == "load_inertia_error")) {
    names.emplace_back(name == "reflected_inertia" ? "load_inertia_error" : "reflected_inertia");
    if (kind != LoadKind::kPendulum) names.emplace_back("torque_constant_error");
  }
  if (sensorless && name == "torque_constant_error") {
    append(names, kind == LoadKind::kPendulum ? Names{"load_mass_error"}
                                              : Names{"reflected_inertia", "load_inertia_error"});
  }
  if (name == "load_mass_error") names.emplace_back("torque_constant_error");
  const bool whole = plant.ratio == std::round(plant.ratio);
  if (name == "cogging_torque" && whole) names.emplace_back("gear_ripple");
  if (name == "gravity_imbalance") names.emplace_back("gear_ripple");
  return names;
}

std::string draw_declared(const Plant& plant, const Names& hidden, Draw& draw) {
  for (const std::string& name : hidden) {  // these vary a dry friction that must be known
    if (name == "position_dependent_friction" || name == "friction_temperature") {
      return "coulomb_friction";
    }
  }
  if (draw.chance(0.5)) return "";
  Names choices{"coulomb_friction", "viscous_friction", "quadratic_drag"};
  if (plant.is_voltage_driven()) {
    choices.emplace_back("inverter_dead_time");
  } else {
    choices.emplace_back("torque_constant_saturation");
  }
  for (const std::string& name : hidden) {
    std::erase(choices, name);
    if (name == "asymmetric_friction") std::erase(choices, "quadratic_drag");
  }
  const std::string choice = draw.one_of(choices);
  // What replaces a Coulomb friction is mostly found beside it.
  const bool replaces = contains(hidden, "stribeck_friction") ||
                        contains(hidden, "presliding_friction") ||
                        contains(hidden, "asymmetric_friction");
  return replaces ? "coulomb_friction" : choice;
}

}  // namespace torquewright::oracles::sampled
