// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/region/smooth_step.hpp"

namespace torquewright::hopper {

/// 10 s^3 - 15 s^4 + 6 s^5.
Taylor SmoothStep::at(double speed_rad_s) const {
  const double width = to_rad_s - from_rad_s;
  const double s = (speed_rad_s - from_rad_s) / width;
  if (s <= 0.0) return {};
  if (s >= 1.0) return {.value = 1.0};
  return {.value = s * s * s * (10.0 + s * (6.0 * s - 15.0)),
          .x = 30.0 * s * s * (1.0 - s) * (1.0 - s) / width,
          .xx = 60.0 * s * (1.0 - s) * (1.0 - 2.0 * s) / (width * width)};
}

Taylor SmoothStep::between(const SmoothCurve& before, const SmoothCurve& after,
                           double speed_rad_s) const {
  if (speed_rad_s >= to_rad_s) return after.at(speed_rad_s);
  const Taylor f = before.at(speed_rad_s);
  if (speed_rad_s <= from_rad_s) return f;
  const Taylor g = after.at(speed_rad_s);
  const Taylor s = at(speed_rad_s);
  const double rise = g.value - f.value;
  const double rise_x = g.x - f.x;
  return {.value = f.value + s.value * rise,
          .x = f.x + s.x * rise + s.value * rise_x,
          .xx = f.xx + s.xx * rise + 2.0 * s.x * rise_x + s.value * (g.xx - f.xx)};
}

}  // namespace torquewright::hopper
