// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace torquewright::identification {

/// A joint's motion at one sample, smoothed.
struct Motion {
  double position_rad = 0.0, speed_rad_s = 0.0, acceleration_rad_s2 = 0.0;
};

/// The parabola of least squares through the samples `at` - `half` to `at` + `half`, which must be
/// there.
Motion parabola(const std::vector<double>& time_s, const std::vector<double>& values,
                std::size_t at, std::size_t half);

/// Samples to each side over which a motion is taken as a parabola, by the times' mean step.
std::size_t half_of_parabola(const std::vector<double>& time_s);

}  // namespace torquewright::identification
