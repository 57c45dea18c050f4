// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "actuator/motor/actuator.hpp"
#include "identification/rig/rig.hpp"

namespace torquewright::identification {

/// What is written about: an actuator with what was found, and what it moves.
struct OutputSubject {
  const actuator::Actuator& actuator;
  const Load& load;
};

/// The numbers of another program's model. One file each in this folder, one line in
/// every_output.hpp. docs/logs.md derives them. Throws io::SpecError where the model cannot hold
/// the actuator at all; what of it has no counterpart is said in the text.
struct Output {
  std::string_view name;    ///< As in --as.
  std::string_view what;    ///< For the help.
  std::string_view source;  ///< Where the model is documented.
  std::string (*write)(const OutputSubject& subject);
};

std::span<const Output* const> output_library();

/// Throws io::SpecError for a name that no output has.
const Output& output_of(std::string_view name);

/// Torque at the output per ampere, where saturation has not begun.
double torque_per_ampere_Nm_A(const actuator::Actuator& actuator);

/// The only value of an effect's parameter; 0 where the actuator does not state the effect.
double stated(const actuator::Actuator& actuator, std::string_view effect,
              std::string_view parameter);

/// The actuator's effects that are none of these, in words: "a, b".
std::string others(const actuator::Actuator& actuator, std::span<const std::string_view> known);

}  // namespace torquewright::identification
