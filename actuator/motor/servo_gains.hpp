// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <string_view>

namespace torquewright::actuator {

/// Gains of a servo that is told angles, where nobody tuned any.
struct ServoGains {
  double kp_Nm_rad = 0.0;
  double kv_Nm_s_rad = 0.0;
};

inline constexpr double kServo_Hz = 10.0;
inline constexpr double kServoDamping = 2.0;
inline constexpr std::string_view kServoSource = "mjlab, unitree_g1/g1_constants.py @ 0234b2e9";

/// Those of mjlab's robots, src/mjlab/asset_zoo/robots/unitree_g1/g1_constants.py @ 0234b2e9: kp =
/// I w^2 and kv = 2 z I w of the drive's own inertia at the joint, w = 2 pi 10 Hz and z = 2.
constexpr ServoGains servo_gains(double inertia_kg_m2) {
  constexpr double kServo_rad_s = 2.0 * std::numbers::pi * kServo_Hz;
  return {inertia_kg_m2 * kServo_rad_s * kServo_rad_s,
          2.0 * kServoDamping * inertia_kg_m2 * kServo_rad_s};
}

}  // namespace torquewright::actuator
