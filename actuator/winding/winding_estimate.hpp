// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "actuator/motor/actuator.hpp"

namespace torquewright::actuator {

/// What is known of the winding behind a curve, at the motor's shaft and as one equivalent (dc)
/// winding.
struct KnownWinding {
  std::optional<double> torque_constant_Nm_A;
  std::optional<double> resistance_ohm;  ///< Between two terminals.
  std::optional<double> voltage_V;
  std::optional<double> current_A;  ///< At the peak torque.
};

/// Numbers from `low` to `high`; high infinite: nothing bounds it.
struct WindingInterval {
  double low = 0.0;
  double high = 0.0;
};

/// What a curve and two or more of those leave of all four; nothing silently: it is an estimate,
/// with what it rests on.
struct WindingEstimate {
  WindingInterval torque_constant_Nm_A;
  WindingInterval resistance_ohm;
  WindingInterval voltage_V;
  WindingInterval current_A;
  std::vector<std::string> rests_on;
  /// What cannot be together, by name; empty: all agrees within rounding and the gears' losses.
  std::string contradiction;
};

/// With rotor speeds N w and one winding, where the curve's peak torque T ends at speed c and its
/// torque at speed e:
///
///     (1) T = eta N K I    (2) V = K N e    (3) V = R I + K N c
///
/// A curve that states no speed at which its torque ends leaves (2) and (3) inequalities. Numbers
/// stand for what rounds to them; eta of gears of a curve that holds their losses is 0.9 for each
/// stage of at most 10:1, to 1. Requires an envelope and two of the four.
WindingEstimate winding_estimate(const Actuator& curve, const KnownWinding& known);

}  // namespace torquewright::actuator
