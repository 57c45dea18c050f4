// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

namespace torquewright::actuator {

/// Removes the whole turns of an angle that was recorded within one turn. A step is a wrap where it
/// is within a quarter turn of a whole one and the step before was less than a quarter turn:
/// samples so far apart that a joint turns more between them are left as they are.
class AngleUnwrap {
 public:
  double next(double time_s, double angle_rad) {
    constexpr double kTurn = 2.0 * std::numbers::pi;
    constexpr double kQuarter = 0.25 * kTurn;
    if (previous_rad_) {
      const double step_rad = angle_rad - *previous_rad_;
      const double turns = std::abs(step_rad) < 1.5 * kTurn ? std::round(step_rad / kTurn) : 0.0;
      const double rest_rad = step_rad - turns * kTurn;
      const bool wraps =
          turns != 0.0 && std::abs(rest_rad) <= kQuarter && std::abs(last_step_rad_) <= kQuarter;
      if (wraps) {
        offset_rad_ -= turns * kTurn;
        if (count_++ == 0) first_s_ = time_s;
      }
      last_step_rad_ = wraps ? rest_rad : step_rad;
    }
    previous_rad_ = angle_rad;
    return angle_rad + offset_rad_;
  }

  std::size_t count() const { return count_; }
  double first_s() const { return first_s_; }  ///< Time of the first wrap.

 private:
  std::optional<double> previous_rad_;
  double last_step_rad_ = 0.0;
  double offset_rad_ = 0.0;
  std::size_t count_ = 0;
  double first_s_ = 0.0;
};

}  // namespace torquewright::actuator
