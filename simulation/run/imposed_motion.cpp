// SPDX-License-Identifier: Apache-2.0
#include "simulation/run/imposed_motion.hpp"

#include <algorithm>

namespace torquewright::simulation {

ImposedMotion::ImposedMotion(std::span<const double> time_s, std::span<const double> speed_rad_s,
                             double start_rad)
    : time_s_(time_s.begin(), time_s.end()), speed_(speed_rad_s.begin(), speed_rad_s.end()) {
  const std::size_t count = speed_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1;
    const std::size_t after = std::min(i + 1, count - 1);
    const double span_s = time_s_[after] - time_s_[before];
    slope_.push_back(span_s > 0.0 ? (speed_[after] - speed_[before]) / span_s : 0.0);
  }
  position_.push_back(start_rad);
  for (std::size_t i = 0; i + 1 < count; ++i) {
    position_.push_back(at(i, time_s_[i + 1]).position_rad);
  }
}

ImposedMotion::Point ImposedMotion::at(std::size_t knot, double time_s) const {
  const std::size_t next = std::min(knot + 1, speed_.size() - 1);
  if (next == knot) return {position_[knot], speed_[knot], slope_[knot]};
  const double step = time_s_[next] - time_s_[knot];
  const double s = (time_s - time_s_[knot]) / step;
  // Hermite: v = v0 + m0 s + c s^2 + d s^3 over the interval, m in speed per interval.
  const double m0 = slope_[knot] * step;
  const double m1 = slope_[next] * step;
  const double rise = speed_[next] - speed_[knot];
  const double c = 3.0 * rise - 2.0 * m0 - m1;
  const double d = m0 + m1 - 2.0 * rise;
  const double moved = s * (speed_[knot] + s * (m0 / 2.0 + s * (c / 3.0 + s * d / 4.0)));
  return {position_[knot] + step * moved, speed_[knot] + s * (m0 + s * (c + s * d)),
          (m0 + s * (2.0 * c + 3.0 * s * d)) / step};
}

}  // namespace torquewright::simulation
