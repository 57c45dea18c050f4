// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/motor/actuator.hpp"

namespace torquewright::actuator::lint {

/// What part of the number that follows from the others a sheet may state, as catalogues do,
/// without contradicting itself. docs/lint.md, "Tolerance".
struct Tolerance {
  double least = 1.0;
  double greatest = 1.0;
};

/// Constants of a catalogue: of windings, magnets, rotors, each within 10 % of the one in hand.
Tolerance catalogue(const Actuator& document);

/// Torques at the sheet's side up to the rated one: constants, and gears of unknown efficiency.
Tolerance rated_torques(const Actuator& document);

/// Torques beyond the rated one: saturation takes its share of these as well.
Tolerance peak_torques(const Actuator& document);

}  // namespace torquewright::actuator::lint
