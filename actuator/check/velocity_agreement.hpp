// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace torquewright::actuator {

/// Compares a logged velocity with the slope of the logged position, over all samples.
class VelocityAgreement {
 public:
  void add(double velocity_rad_s, double slope_rad_s) {
    ++samples_;
    velocity_sum_ += velocity_rad_s;
    slope_sum_ += slope_rad_s;
    product_ += velocity_rad_s * slope_rad_s;
    velocity_square_ += velocity_rad_s * velocity_rad_s;
    slope_square_ += slope_rad_s * slope_rad_s;
  }

  /// Factor of velocity over slope, by least squares; 1 where nothing moves.
  double factor() const { return slope_square_ > 0.0 ? product_ / slope_square_ : 1.0; }

  /// Squared correlation. 1: the one is the other times the factor; 0: they have nothing in common,
  /// or there are too few samples to tell.
  double correlation() const {
    const double squares = velocity_square_ * slope_square_;
    return samples_ < kFewest || !(squares > 0.0) ? 0.0 : product_ * product_ / squares;
  }

  /// Factor of both about their means, which an offset does not change.
  double factor_about_means() const {
    const double spread = spread_of(slope_sum_, slope_sum_, slope_square_);
    return spread > 0.0 ? spread_of(velocity_sum_, slope_sum_, product_) / spread : 1.0;
  }
  double correlation_about_means() const {
    const double both = spread_of(velocity_sum_, slope_sum_, product_);
    const double squares = spread_of(velocity_sum_, velocity_sum_, velocity_square_) *
                           spread_of(slope_sum_, slope_sum_, slope_square_);
    return samples_ < kFewest || !(squares > 0.0) ? 0.0 : both * both / squares;
  }

  /// Mean of velocity less slope, and its standard deviation.
  double offset_rad_s() const {
    return samples_ == 0 ? 0.0 : (velocity_sum_ - slope_sum_) / static_cast<double>(samples_);
  }
  double scatter_rad_s() const {
    const double sum = velocity_sum_ - slope_sum_;
    const double square = velocity_square_ - 2.0 * product_ + slope_square_;
    return samples_ == 0 ? 0.0
                         : std::sqrt(std::max(0.0, spread_of(sum, sum, square)) /
                                     static_cast<double>(samples_));
  }

 private:
  /// Sum of products about the means, from both sums and that of the products.
  double spread_of(double one_sum, double other_sum, double product_sum) const {
    return product_sum - one_sum * other_sum / static_cast<double>(samples_);
  }

  static constexpr std::size_t kFewest = 20;
  std::size_t samples_ = 0;
  double velocity_sum_ = 0.0;
  double slope_sum_ = 0.0;
  double product_ = 0.0;
  double velocity_square_ = 0.0;
  double slope_square_ = 0.0;
};

}  // namespace torquewright::actuator
