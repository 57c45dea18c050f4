// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::actuator {

/// Integral over time of values at uneven instants, by the trapezoidal rule.
class Integral {
 public:
  void add(double time_s, double value) {
    if (has_previous_) sum_ += 0.5 * (previous_ + value) * (time_s - previous_s_);
    has_previous_ = true;
    previous_s_ = time_s;
    previous_ = value;
  }
  double sum() const { return sum_; }

 private:
  bool has_previous_ = false;
  double previous_s_ = 0.0;
  double previous_ = 0.0;
  double sum_ = 0.0;
};

}  // namespace torquewright::actuator
