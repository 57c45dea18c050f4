// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "gearbox/teeth/tooth_form.hpp"

namespace torquewright::gearbox {

/// A point of a plane; the unit is that of whoever holds it.
struct Point {
  double x = 0.0;
  double y = 0.0;
};

/// `point` turned about the origin, counter-clockwise positive.
Point turned(const Point& point, double angle_rad);

/// A smooth piece of an outline: point(t) for t from `from` to `to` [modules].
struct OutlineCurve {
  std::function<Point(double)> point;
  double from = 0.0;
  double to = 0.0;
  bool is_flank = false;  ///< The involute, on which gears touch.
};

/// Half of one pitch of a gear, from the middle of the tooth (internal: of the space) on the x axis
/// counter-clockwise to the middle of the space (internal: of the tooth); gear axis at the origin.
std::vector<OutlineCurve> half_pitch_curves(const ToothForm& form);

/// One whole pitch counter-clockwise, symmetric about the x axis.
std::vector<OutlineCurve> pitch_curves(const ToothForm& form);

/// Points of consecutive curves, no chord farther than `chord_error` from its curve.
std::vector<Point> sample(const std::vector<OutlineCurve>& curves, double chord_error);

}  // namespace torquewright::gearbox
