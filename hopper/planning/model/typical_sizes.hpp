// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::hopper::typical {

// Sizes by which the solver's numbers come near 1: of unknowns and of rows.
inline constexpr double kLength_m = 0.5;
inline constexpr double kAngle_rad = 1.0;
inline constexpr double kSpeed = 5.0;           // m/s or rad/s
inline constexpr double kAcceleration = 100.0;  // m/s^2 or rad/s^2
inline constexpr double kTorque_Nm = 100.0;
inline constexpr double kForce_N = 100.0;
inline constexpr double kImpulse_N_s = 10.0;
inline constexpr double kDuration_s = 0.3;
inline constexpr double kVoltage = 0.1;  // of the open circuit's

}  // namespace torquewright::hopper::typical
