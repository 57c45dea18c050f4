// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "identification/dictionary.hpp"

namespace torquewright::identification {
namespace {

constexpr double kNearlyAll = 0.99;

/// Reach of one value: nothing until a value was taken.
struct Reach {
  double least = INFINITY, greatest = -INFINITY;
  void take(double value) {
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  double width() const { return greatest - least; }
};

/// The magnitude that 1 % of the values exceed, and at least a trifle.
double nearly_greatest(std::vector<double>& values) {
  if (values.empty()) return 1e-6;
  const auto place = kNearlyAll * static_cast<double>(values.size() - 1);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(place);
  std::nth_element(values.begin(), at, values.end());
  return std::max(*at, 1e-6);
}

void take_angles(const Signals& stretch, Extent& extent) {
  Reach output, motor;
  for (const actuator::Instant& at : stretch.at) {
    output.take(at.output_angle_rad);
    motor.take(at.motor_angle_rad);
  }
  extent.output_angle_rad = std::max(extent.output_angle_rad, output.width());
  extent.motor_angle_rad = std::max(extent.motor_angle_rad, motor.width());
}

void take_temperatures(const std::vector<Signals>& signals, Extent& extent) {
  for (const Signals& stretch : signals) {
    for (const actuator::Instant& at : stretch.at) {
      extent.warmth_K = std::max(extent.warmth_K,
                                 std::abs(at.winding_temperature_K - at.reference_temperature_K));
    }
  }
}

/// Of the usable samples, those slower than a tenth of `fast_rad_s`.
double slow_share(const std::vector<Signals>& signals, double fast_rad_s) {
  std::size_t slow = 0, moving = 0;
  for (const Signals& stretch : signals) {
    for (std::size_t i = 0; i < stretch.size(); ++i) {
      if (stretch.usable[i] == 0) continue;
      ++moving;
      slow += std::abs(stretch.at[i].speed_rad_s) < 0.1 * fast_rad_s;
    }
  }
  return moving > 0 ? static_cast<double>(slow) / static_cast<double>(moving) : 0.0;
}

}  // namespace

Extent extent_of(const std::vector<Signals>& signals) {
  Extent extent;
  std::vector<double> speeds_rad_s, currents_A;
  for (const Signals& stretch : signals) {
    for (const actuator::Instant& at : stretch.at) {
      speeds_rad_s.push_back(std::abs(at.speed_rad_s));
      currents_A.push_back(std::abs(at.current_A));
    }
    take_angles(stretch, extent);
  }
  take_temperatures(signals, extent);
  extent.speed_rad_s = nearly_greatest(speeds_rad_s);
  extent.current_A = nearly_greatest(currents_A);
  extent.slow_share = slow_share(signals, extent.speed_rad_s);
  return extent;
}

}  // namespace torquewright::identification
