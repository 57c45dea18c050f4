// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "actuator/motor/actuator.hpp"
#include "gearbox/problem.hpp"

namespace torquewright::actuator {

/// The gears of a design as what stands between a rotor and a joint, or why they are no such thing.
struct GearTransmission {
  Transmission transmission;
  std::string objection;  ///< A sentence; empty: none.
  std::string place;      ///< JSON pointer of what is objected to; empty: the design as a whole.
};

/// Ratio, efficiencies and inertia at the output as `evaluate` computes them from the teeth, and
/// the torque that these bear for the problem's cycles, where its steel and face widths are known;
/// the problem's rotor is left out. Requires a friction coefficient and tooth counts of the
/// topology.
GearTransmission gear_transmission(const gearbox::Problem& problem, const gearbox::Design& design);

/// Whether the data sheet's rated torque is one of the joint, behind the gears; else of the motor.
bool is_rated_at_joint(const Actuator& actuator);

/// For an actuator that has other gears than `before`: what the motor may give for long is the
/// same, and a rated torque at the joint goes with ratio and forward efficiency.
void carry_joint_rating(const Transmission& before, Actuator& actuator);

}  // namespace torquewright::actuator
