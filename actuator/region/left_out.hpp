// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "actuator/motor/actuator.hpp"

namespace torquewright::actuator {

/// A part of the program that reckons with an actuator's document: each holds other effects.
enum class Part {
  kRegion,  ///< Torque over speed: tables, exporters.
  kCheck,   ///< A motion or a simulator's robot with that region: inertia counts besides.
  kReplay,  ///< A simulated robot: what has a history or an angle acts, by simulation/joint.
};

/// Whether that part reckons with the effect.
bool holds(Part part, const Effect& effect);

/// The effects of the document that the part does not reckon with, in its order.
std::vector<const Effect*> effects_left_out(const Actuator& actuator, Part part);

/// Why a part does not.
std::string left_out_sentence(const Effect& effect);

/// A sentence for each of them, and for each thing that the document leaves open.
std::vector<std::string> left_out(const Actuator& actuator, Part part);

}  // namespace torquewright::actuator
