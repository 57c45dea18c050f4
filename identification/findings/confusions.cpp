// SPDX-License-Identifier: Apache-2.0
#include "identification/findings/confusions.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/effects/library.hpp"

namespace torquewright::identification {
namespace {

using actuator::Excitation;
using actuator::StandsFor;
using Names = std::vector<std::string>;

bool has(const Names& effects, std::string_view name) {
  return std::find(effects.begin(), effects.end(), name) != effects.end();
}

/// The actuator's effects that look so in a balance of torques, then the others.
Names alike(StandsFor what, const Names& others = {}) {
  Names names;
  for (const actuator::EffectKind* each : actuator::effects_standing_for(what)) {
    names.emplace_back(each->name);
  }
  names.insert(names.end(), others.begin(), others.end());
  return names;
}

/// What the rig's own values and its torque sensor's response may stand for, whether it calls them
/// uncertain or not: no log says who is right. Gains of sensors are what all is measured by: they
/// are trusted (docs/decisions/0025), but for one that differs by sign, which one of two sensors
/// has.
std::vector<Names> groups_of_the_rig(const Bench& bench) {
  if (bench.load_side == LoadSide::kSensor)
    return {alike(StandsFor::kSensorLag, {"channel_lag"}),
            {"current_gain_error", "torque_gain_error"}};
  if (bench.load_side != LoadSide::kModel) return {};
  switch (bench.rig->load.type) {
    case LoadType::kFree:
      return {
          alike(StandsFor::kTorqueScale, alike(StandsFor::kLoadInertia, {"load_inertia_error"}))};
    case LoadType::kLinearAxis:
      return {alike(StandsFor::kTorqueScale, alike(StandsFor::kLoadInertia, {"load_mass_error"}))};
    case LoadType::kPendulum:
    case LoadType::kSerialArm:
    case LoadType::kRobot:
      return {alike(StandsFor::kTorqueScale, {"load_mass_error"}),
              alike(StandsFor::kLoadInertia, {"load_inertia_error"})};
    case LoadType::kDynamometer:
      break;
  }
  return {};
}

Names waves_that_act(actuator::Acts acts) {
  Names names;
  for (const actuator::EffectKind* each : actuator::effect_library()) {
    if (each->has_harmonics && each->acts == acts) names.emplace_back(each->name);
  }
  return names;
}

/// Where it may be an inertia of the load's model.
constexpr int kRankOfInertia = 12;

/// What excites a single effect beside those; of the actuator what its record says.
Excitation excitation_of(const Bench& bench, const std::string& effect, const Names& beside) {
  if (effect == "torque_offset" || effect == "current_offset") {
    return {1, "a tare with the drive off, the voltage equation, or rest reached from both sides"};
  }
  if (effect == "channel_lag") {
    return {2,
            "the torque sensor's own response, measured with the drive held still, or a load of "
            "known inertia"};
  }
  if (effect == "torque_gain_error") {
    return {1, "known weights on the torque sensor, one after another on either side"};
  }
  if (effect == "channel_delay") return actuator::effects::kFastMotion;
  if (effect == "load_length_error") {
    return {11, "a load that was weighed and balanced, or another known one"};
  }
  const bool is_inertia =
      effect == "load_inertia_error" || actuator::stands_for(effect, StandsFor::kLoadInertia);
  if (is_inertia && bench.load_side == LoadSide::kModel) {
    if (has(beside, "load_mass_error")) {
      return {kRankOfInertia, "a force sensor, or a second load of known mass"};
    }
    return {kRankOfInertia,
            "a torque sensor, or a second load of known inertia; where all but one value is known "
            "to be right, that one as \"uncertain\" in the rig (/load/inertia_kg_m2, "
            "/motor/torque_constant_Nm_A)"};
  }
  if (effect == "load_mass_error") {
    return {13,
            "a second known mass, or the voltage equation; where all but one value is known to be "
            "right, that one as \"uncertain\" in the rig (/load/mass_kg, "
            "/motor/torque_constant_Nm_A)"};
  }
  if (effect == "gravity_imbalance") return actuator::effects::kSlowTurn;
  const actuator::EffectKind* kind = actuator::find_effect(effect);
  return kind == nullptr ? actuator::effects::kMixedMotion : kind->excited_by;
}

}  // namespace

std::vector<std::string> exact_identities(const Bench& bench, const std::string& effect) {
  const Names of_motor = waves_that_act(actuator::Acts::kMotorSideTorque);
  Names of_output = waves_that_act(actuator::Acts::kOutputTorque);
  // A ripple of the output need not be a multiple of the ratio: only cogging's name is in question.
  if (has(of_output, effect)) return {effect};
  std::vector<Names> groups = groups_of_the_rig(bench);
  groups.push_back({"torque_offset", "current_offset"});
  const Names constants = alike(StandsFor::kOffset);
  groups.back().insert(groups.back().end(), constants.begin(), constants.end());
  const double ratio = bench.actuator().transmission.ratio;
  if (ratio == std::floor(ratio)) {
    groups.push_back(of_motor);
    groups.back().insert(groups.back().end(), of_output.begin(), of_output.end());
  }
  for (const Names& group : groups) {
    if (has(group, effect)) return group;
  }
  return {effect};
}

std::string separated_by(const Bench& bench, const std::vector<std::string>& effects) {
  Excitation first = actuator::effects::kMixedMotion;
  for (const std::string& effect : effects) {
    const Excitation own = excitation_of(bench, effect, effects);
    if (own.rank < first.rank) first = own;
  }
  return std::string(first.sentence);
}

std::string consequence(const std::string& named, const std::vector<std::string>& effects) {
  if (has(effects, "torque_offset") && actuator::find_effect(named) == nullptr) {
    return "As an offset of a sensor nothing changes in the region; as asymmetric friction its "
           "bounds for the two directions move by the value.";
  }
  for (const std::string& effect : effects) {
    const actuator::EffectKind* kind = actuator::find_effect(effect);
    if (kind != nullptr && !kind->consequence.empty()) return std::string(kind->consequence);
  }
  return "";
}

}  // namespace torquewright::identification
