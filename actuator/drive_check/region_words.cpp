// SPDX-License-Identifier: Apache-2.0
#include "actuator/drive_check/region_words.hpp"

#include <fmt/format.h>

#include <cmath>

namespace torquewright::actuator {
namespace {

constexpr double kRounding = 1e-9;  ///< Of the torque that is asked for.

std::string amount(double torque_Nm) { return fmt::format("{:.6g} Nm", std::abs(torque_Nm)); }

/// Whether all that stands against it is that its supply takes nothing back: by its own power
/// (plugging) it could, which counts for nothing (docs/decisions/0007).
bool brakes_into_full_supply(const WorstSample& sample, double torque_Nm) {
  const double limit_Nm = std::abs(sample.limit_Nm.value_or(0.0));
  return sample.limiter == Limiter::kRegeneration && torque_Nm < 0.0 &&
         limit_Nm <= kRounding * std::abs(torque_Nm);
}

}  // namespace

std::string outside_words(const WorstSample& sample) {
  const double speed_rad_s = std::abs(sample.speed_rad_s);
  // Along the motion: positive pushes.
  const double torque_Nm = std::copysign(1.0, sample.speed_rad_s) * sample.torque_Nm;
  const std::string asked =
      torque_Nm == 0.0 ? "turn freely"
                       : (torque_Nm < 0.0 ? "brake with " : "push with ") + amount(torque_Nm);
  if (speed_rad_s > 0.0 && brakes_into_full_supply(sample, torque_Nm)) {
    return fmt::format(
        "at {:.6g} rad/s the drive may not brake: its supply takes nothing back, and "
        "plugging counts for nothing; it is asked to {}",
        speed_rad_s, asked);
  }
  if (!sample.limit_Nm) {
    return fmt::format("at {:.6g} rad/s the drive has no torque at all; it is asked to {}",
                       speed_rad_s, asked);
  }
  if (speed_rad_s == 0.0) {  // No motion to push or to brake.
    return fmt::format("at rest the drive can hold at most {}; it is asked for {}",
                       amount(*sample.limit_Nm), amount(sample.torque_Nm));
  }
  const double limit_Nm = std::copysign(1.0, sample.speed_rad_s) * *sample.limit_Nm;
  const bool brakes = limit_Nm < 0.0;
  // The bound towards what is asked for: more of its own kind, or less.
  const bool is_most = (torque_Nm > limit_Nm) != brakes;
  return fmt::format("at {:.6g} rad/s the drive {} {} with at {} {}; it is asked to {}",
                     speed_rad_s, is_most ? "can" : "must", brakes ? "brake" : "push",
                     is_most ? "most" : "least", amount(limit_Nm), asked);
}

}  // namespace torquewright::actuator
