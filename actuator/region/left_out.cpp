// SPDX-License-Identifier: Apache-2.0
#include "actuator/region/left_out.hpp"

#include <fmt/format.h>

namespace torquewright::actuator {
namespace {

bool turns_on_angle(const Effect& effect) {
  return effect.kind->acts == Acts::kOutputTorque && !effect.kind->has_harmonics;
}

}  // namespace

std::string left_out_sentence(const Effect& effect) {
  return fmt::format("{}: depends on the {}, which no region of torque over speed can hold",
                     effect.kind->name,
                     turns_on_angle(effect) ? "output's angle" : "motion's history");
}

bool holds(Part part, const Effect& effect) {
  if (part == Part::kReplay) return true;
  if (effect.kind->acts == Acts::kInertialTorque) return part == Part::kCheck;
  return effect.kind->acts != Acts::kDynamics && !turns_on_angle(effect);
}

std::vector<const Effect*> effects_left_out(const Actuator& actuator, Part part) {
  std::vector<const Effect*> effects;
  for (const Effect& effect : actuator.effects) {
    if (!holds(part, effect)) effects.push_back(&effect);
  }
  return effects;
}

std::vector<std::string> left_out(const Actuator& actuator, Part part) {
  std::vector<std::string> sentences;
  for (const Effect* effect : effects_left_out(actuator, part)) {
    sentences.push_back(left_out_sentence(*effect));
  }
  const Transmission& gears = actuator.transmission;
  if (!gears.source.empty() && gears.peak_torque_Nm == kUnlimited) {
    sentences.push_back(
        fmt::format("gear strength: {} states no steel and face widths; what its teeth bear is no "
                    "bound here",
                    gears.source));
  }
  if (actuator.envelope) {
    sentences.emplace_back(
        "winding: none stated; current, heat, losses and the bus's sag do not follow from a curve");
    return sentences;
  }
  if (!actuator.battery) sentences.emplace_back("battery: none stated; the bus voltage is stiff");
  if (!actuator.thermal) {
    sentences.emplace_back("thermal: none stated; the winding stays at its temperature");
  }
  if (actuator.motor.inductance_q_H == 0.0 && actuator.motor.inductance_d_H == 0.0) {
    sentences.emplace_back("inductance: none stated; voltage is lost over the resistance alone");
  }
  if (actuator.effects.empty()) {
    sentences.emplace_back("friction: no effects stated; losses are the gearbox's efficiencies");
  }
  return sentences;
}

}  // namespace torquewright::actuator
