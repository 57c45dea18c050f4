// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "actuator/motor/actuator.hpp"
#include "identification/rig/rig.hpp"

namespace torquewright::identification {

/// Errors of a log's channels against the truth.
struct LogErrors {
  std::array<double, kQuantityCount> delay_s{};  ///< Delay of each channel.
  double instant_s = 0.0;  ///< Instant within its step at which the drive's channel was taken.
  double torque_offset_Nm = 0.0;  ///< Measured less true torque; N on a linear axis.
  double current_offset_A = 0.0;
  double positive_current_gain = 1.0;  ///< Measured over true current, for positive currents.
  double negative_current_gain = 1.0;
  /// Amplitudes of the output encoder's error, once and twice a turn.
  std::array<double, 2> encoder_sine_rad{};
  std::array<double, 2> encoder_cosine_rad{};
  double velocity_scale = 1.0;  ///< Logged over true velocity.
  double velocity_delay_s = 0.0;
  double encoder_zero_rad = 0.0;  ///< Motor angle over ratio less output angle, without load.
  double open_circuit_V = 0.0;    ///< Open-circuit voltage of the bus less the stated one.
};

/// Everything that a prediction rests on: what the documents state, and what is supposed beyond
/// them. A supposed effect of the actuator is among the actuator's `effects`.
struct Hypothesis {
  actuator::Actuator actuator;
  Rig rig;
  LogErrors log;
  /// Inductance in the convention of the winding's volts and amperes.
  double winding_inductance_H = 0.0;
  double winding_late_s = 0.0;  ///< Delay of the winding's current behind what drives it.
  /// Gravity of the load beyond the rig's: sine sin(q) + cosine cos(q), in Nm.
  double imbalance_sine_Nm = 0.0, imbalance_cosine_Nm = 0.0;
};

}  // namespace torquewright::identification
