// SPDX-License-Identifier: Apache-2.0
#include "identification/findings/confusions.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::identification {
namespace {

bool has(const std::vector<std::string>& effects, std::initializer_list<const char*> any) {
  return std::any_of(any.begin(), any.end(), [&](const char* name) {
    return std::find(effects.begin(), effects.end(), name) != effects.end();
  });
}

using Names = std::vector<std::string>;

/// What the rig's own values and its torque sensor's response may stand for, whether it calls them
/// uncertain or not: no log says who is right. Gains of sensors are what all is measured by: they
/// are trusted (docs/decisions/0025).
std::vector<Names> groups_of_the_rig(const Bench& bench) {
  if (bench.load_side == LoadSide::kSensor) return {{"torque_lag", "channel_lag"}};
  if (bench.load_side != LoadSide::kModel) return {};
  Names constant = {"torque_constant_error"};
  switch (bench.rig->load.type) {
    case LoadType::kFree:
      constant.insert(constant.end(), {"reflected_inertia", "load_inertia_error"});
      return {constant};
    case LoadType::kLinearAxis:
      constant.insert(constant.end(), {"reflected_inertia", "load_mass_error"});
      return {constant};
    case LoadType::kPendulum:
    case LoadType::kSerialArm:
      constant.emplace_back("load_mass_error");
      return {constant, {"reflected_inertia", "load_inertia_error"}};
    case LoadType::kDynamometer:
      break;
  }
  return {};
}

}  // namespace

std::vector<std::string> exact_identities(const Bench& bench, const std::string& effect) {
  // A ripple of the output need not be a multiple of the ratio: only cogging's name is in question.
  if (effect == "gear_ripple") return {effect};
  std::vector<Names> groups = groups_of_the_rig(bench);
  groups.push_back({"torque_offset", "current_offset", "asymmetric_friction"});
  const double ratio = bench.actuator().transmission.ratio;
  if (ratio == std::floor(ratio)) groups.push_back({"cogging_torque", "gear_ripple"});
  for (const Names& group : groups) {
    if (std::find(group.begin(), group.end(), effect) != group.end()) return group;
  }
  return {effect};
}

std::string separated_by(const Bench& bench, const std::vector<std::string>& effects) {
  if (has(effects, {"torque_offset", "current_offset"})) {
    return "a tare with the drive off, the voltage equation, or rest reached from both sides";
  }
  if (has(effects, {"channel_lag"})) {
    return "the torque sensor's own response, measured with the drive held still, or a load of "
           "known "
           "inertia";
  }
  if (has(effects, {"torque_lag", "channel_delay"})) {
    return "motion so fast that lag times angular frequency exceeds 0.5, or a second pair of "
           "channels";
  }
  if (has(effects, {"load_length_error"})) {
    return "a load that was weighed and balanced, or another known one";
  }
  if (has(effects, {"reflected_inertia", "load_inertia_error"}) &&
      bench.load_side == LoadSide::kModel) {
    return has(effects, {"load_mass_error"})
               ? "a force sensor, or a second load of known mass"
               : "a torque sensor, or a second load of known inertia; where all but one value is "
                 "known to be right, that one as \"uncertain\" in the rig (/load/inertia_kg_m2, "
                 "/motor/torque_constant_Nm_A)";
  }
  if (has(effects, {"load_mass_error"})) {
    return "a second known mass, or the voltage equation; where all but one value is known to be "
           "right, that one as \"uncertain\" in the rig (/load/mass_kg, "
           "/motor/torque_constant_Nm_A)";
  }
  if (has(effects, {"friction_temperature", "torque_constant_temperature",
                    "winding_resistance_temperature"})) {
    return "cold and warm runs in turn, the same motion in each";
  }
  if (has(effects, {"stribeck_friction", "presliding_friction"})) {
    return "speeds down to a tenth of the Stribeck velocity, and strokes of one to five presliding "
           "lengths";
  }
  if (has(effects, {"load_dependent_friction"})) {
    return "driving and back-driving at each load";
  }
  if (has(effects, {"viscous_friction", "quadratic_drag", "coulomb_friction"})) {
    return "steady speeds that differ by a factor of four, in both directions";
  }
  if (has(effects, {"torque_constant_saturation", "torque_constant_error"})) {
    return "three loads of both signs, the largest near the peak current";
  }
  if (has(effects, {"cogging_torque", "gear_ripple", "gravity_imbalance"})) {
    return "a slow turn of the whole range, and an encoder on the motor";
  }
  return "a mix of slow and fast motion in both directions under several loads";
}

std::string consequence(const std::string& named, const std::vector<std::string>& effects) {
  if (named == "asymmetric_friction") {
    return "As an offset of a sensor the friction that both directions have in common remains, the "
           "mean of their two values; as asymmetric friction each direction has its own.";
  }
  if (has(effects, {"torque_offset"})) {
    return "As an offset of a sensor nothing changes in the region; as asymmetric friction its "
           "bounds for the two directions move by the value.";
  }
  if (has(effects, {"torque_constant_error"})) {
    return "As an error of the torque constant all torques of the region change by the factor; as "
           "any other, none.";
  }
  if (has(effects, {"load_inertia_error"})) {
    return "As inertia of the rotor it takes torque wherever the actuator accelerates; as an error "
           "of the rig nothing changes.";
  }
  if (has(effects, {"channel_lag"})) {
    return "As a lag of the torque it is late by so much; as one of the sensor nothing changes.";
  }
  return "";
}

}  // namespace torquewright::identification
