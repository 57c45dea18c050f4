// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace torquewright::actuator {

/// A logged velocity against the slope of the logged position, over all samples.
class VelocityAgreement {
 public:
  void add(double velocity_rad_s, double slope_rad_s) {
    ++samples_;
    product_ += velocity_rad_s * slope_rad_s;
    velocity_square_ += velocity_rad_s * velocity_rad_s;
    slope_square_ += slope_rad_s * slope_rad_s;
  }

  /// Least squares: velocity = factor slope. 1 where nothing moves.
  double factor() const { return slope_square_ > 0.0 ? product_ / slope_square_ : 1.0; }

  /// 1: the one is the other times the factor; 0: they have nothing in common, or there are too few
  /// samples to tell.
  double correlation() const {
    const double squares = velocity_square_ * slope_square_;
    return samples_ < kFewest || !(squares > 0.0) ? 0.0 : product_ * product_ / squares;
  }

 private:
  static constexpr std::size_t kFewest = 20;
  std::size_t samples_ = 0;
  double product_ = 0.0;
  double velocity_square_ = 0.0;
  double slope_square_ = 0.0;
};

}  // namespace torquewright::actuator
