// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/lint/rounded_interval.hpp"
#include "actuator/motor/actuator.hpp"

namespace torquewright::actuator::lint {

/// The range, as shares of the number that follows from the others, that a sheet may state without
/// contradicting itself (docs/lint.md, "Tolerance").
struct Tolerance {
  double least = 1.0;
  double greatest = 1.0;
};

/// Share by which catalogues' constants differ from those of the motor in hand, either way
/// (docs/lint.md, "Tolerance": catalogues print typical constants, usually with +-10 %).
constexpr double kCatalogueShare = 0.1;

/// The two numbers that are compared; their pointers say what each rests on.
struct Compared {
  const Actuator& document;
  const RoundedInterval& stated;
  const RoundedInterval& expected;
};

/// Tolerance of a catalogue's constants: of windings, magnets, rotors, each within 10 % of the one
/// in hand; none where the source states tolerances of its own, which the intervals then hold.
Tolerance catalogue(const Compared& compared);

/// Tolerance of a speed, or a speed per volt, that follows from the torque constant. Where that is
/// no more than stall torque over stall current, saturation at stall has taken its share of it, and
/// the speed may be as much lower.
Tolerance speeds(const Compared& compared);

/// Tolerance of torques at the sheet's side up to the rated one: constants, and gears of unknown
/// efficiency.
Tolerance rated_torques(const Compared& compared);

/// Tolerance of torques beyond the rated one: saturation takes its share as well.
Tolerance peak_torques(const Compared& compared);

}  // namespace torquewright::actuator::lint
