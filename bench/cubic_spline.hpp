// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace torquewright::bench {

struct SplinePoint {
  double value = 0;
  double rate = 0;
  double second_rate = 0;
};

/// Twice continuously differentiable; lies between its control points. Clamped: begins at the first
/// and ends at the last.
class CubicSpline {
 public:
  /// Between breaks (ascending, ends included) cubics; breaks.size() + 2 control points.
  CubicSpline(const std::vector<double>& breaks, std::vector<double> controls);
  SplinePoint at(double place) const;

 private:
  std::vector<double> knots_;
  std::vector<double> controls_;
};

}  // namespace torquewright::bench
