// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace torquewright::simulation {

/// A motion through given speeds at given times. The speed is a cubic with continuous slope in each
/// interval and the position its exact integral, so that position, speed and acceleration agree.
class ImposedMotion {
 public:
  struct Point {
    double position_rad = 0.0, speed_rad_s = 0.0, acceleration_rad_s2 = 0.0;
  };

  ImposedMotion(std::span<const double> time_s, std::span<const double> speed_rad_s,
                double start_rad);

  /// Returns the motion at a time within interval `knot` (from its knot to the next).
  Point at(std::size_t knot, double time_s) const;

 private:
  std::vector<double> time_s_, speed_, slope_, position_;
};

}  // namespace torquewright::simulation
