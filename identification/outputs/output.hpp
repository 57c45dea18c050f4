// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "actuator/motor/actuator.hpp"
#include "identification/rig/rig.hpp"

namespace torquewright::identification {

/// What an output writes about: an actuator with what was found, and its load.
struct OutputSubject {
  const actuator::Actuator& actuator;
  const Load& load;
};

/// A format for another program's model. Each is one file in this folder and one line in
/// every_output.hpp; docs/logs.md derives the numbers. Throws io::SpecError where the model cannot
/// hold the actuator at all; what has no counterpart is said in the text.
struct Output {
  std::string_view name;    ///< Name as in --as.
  std::string_view what;    ///< Description for the help.
  std::string_view source;  ///< Where the model is documented.
  std::string (*write)(const OutputSubject& subject);
};

std::span<const Output* const> output_library();

/// Returns the output of that name. Throws io::SpecError for a name that no output has.
const Output& output_of(std::string_view name);

/// Torque at the output per ampere, below saturation.
double torque_per_ampere_Nm_A(const actuator::Actuator& actuator);

/// Returns the value of an effect's only parameter; 0 where the actuator does not state the effect.
double stated(const actuator::Actuator& actuator, std::string_view effect,
              std::string_view parameter);

/// Names the actuator's effects that are none of these: "a, b".
std::string others(const actuator::Actuator& actuator, std::span<const std::string_view> known);

}  // namespace torquewright::identification
