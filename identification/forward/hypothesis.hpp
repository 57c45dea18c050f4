// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "actuator/motor/actuator.hpp"
#include "identification/rig/rig.hpp"

namespace torquewright::identification {

/// What a log's channels may have done to the truth.
struct LogErrors {
  std::array<double, kQuantityCount> delay_s{};  ///< By which a channel is late.
  double instant_s = 0.0;         ///< Of its step, at which the drive's channel was taken.
  double torque_offset_Nm = 0.0;  ///< measured = true + offset; N on a linear axis.
  double current_offset_A = 0.0;
  double positive_current_gain = 1.0;  ///< Measured over true, of positive currents.
  double negative_current_gain = 1.0;
  std::array<double, 2> encoder_sine_rad{};  ///< Of the output's encoder: once a turn, and twice.
  std::array<double, 2> encoder_cosine_rad{};
  double velocity_scale = 1.0;  ///< Of the logged velocity.
  double velocity_delay_s = 0.0;
  double encoder_zero_rad = 0.0;  ///< Motor angle over ratio less output angle, unloaded.
  double open_circuit_V = 0.0;    ///< Of the bus without load, above the stated one.
};

/// Everything that a prediction rests on: what the documents state, and what is supposed beyond
/// them. An effect of the actuator is one of its `effects`.
struct Hypothesis {
  actuator::Actuator actuator;
  Rig rig;
  LogErrors log;
  double winding_inductance_H = 0.0;  ///< As the winding's volts and amperes count.
  double winding_late_s = 0.0;        ///< By which its current follows what drives it.
  /// Of the load's gravity, beyond the rig's: what it takes is sine sin(q) + cosine cos(q).
  double imbalance_sine_Nm = 0.0, imbalance_cosine_Nm = 0.0;
};

}  // namespace torquewright::identification
