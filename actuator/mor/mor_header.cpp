// SPDX-License-Identifier: Apache-2.0
#include "actuator/mor/mor_header.hpp"

#include <fmt/format.h>

namespace torquewright::actuator {

std::string_view name_of(Side side) { return side == Side::kJoint ? "joint" : "motor"; }

std::string_view name_of(Rating rating) { return rating == Rating::kPeak ? "peak" : "continuous"; }

std::string friction_sentence(const MorHeader& header) {
  if (header.side == Side::kMotor) return "none: torque at the rotor, before any friction";
  const std::optional<Envelope>& envelope = header.actuator->envelope;
  if (envelope && envelope->includes_losses) return "all: the curve is what leaves the joint";
  const Transmission& gear = header.actuator->transmission;
  std::string sentence = fmt::format("gearbox efficiencies {:.4g} driving, {:.4g} back-driven",
                                     gear.forward_efficiency, gear.backward_efficiency);
  for (const Effect& effect : header.actuator->effects) {
    const bool is_friction = effect.kind->acts == Acts::kDrag ||
                             effect.kind->acts == Acts::kLoadFriction ||
                             effect.kind->acts == Acts::kDragFactor;
    if (is_friction) sentence += fmt::format("; {}", effect.kind->name);
  }
  return sentence;
}

}  // namespace torquewright::actuator
