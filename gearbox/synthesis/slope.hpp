// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "optimization/expressions/interval.hpp"

namespace torquewright::gearbox {

using optimization::Interval;

/// The variables of a layer: centre distance [mm], shift of its planet [modules].
inline constexpr std::size_t kInnerVariables = 2;

/// A range of each.
using InnerBox = std::array<Interval, kInnerVariables>;

/// An enclosure of a function over a box, of its slopes there and of its value at a point c of the
/// box: for any x of the box, f(x) lies in f(c) + slopes (x - c), as far as f is defined between.
/// Outward rounded; what is outside a function's domain is left out of its value, and its slopes
/// are then the whole line. Every value is cut to what the slopes leave of it.
struct Slope {
  Interval value;
  Interval center;
  std::array<Interval, kInnerVariables> slopes{};
  const InnerBox* offsets = nullptr;  ///< x - c over the box; null: a constant.

  Slope() = default;
  Slope(double number) : value(number), center(number) {}  // NOLINT: a number is a function
};

/// A box with its middle.
class InnerPlace {
 public:
  explicit InnerPlace(const InnerBox& box);
  /// The variable itself. The place must outlive it.
  Slope variable(std::size_t which) const;
  const InnerBox& offsets() const { return offsets_; }
  const std::array<double, kInnerVariables>& middle() const { return middle_; }

 private:
  InnerBox box_;
  std::array<double, kInnerVariables> middle_{};
  InnerBox offsets_;
};

Slope operator-(const Slope& a);
Slope operator+(const Slope& a, const Slope& b);
Slope operator-(const Slope& a, const Slope& b);
Slope operator*(const Slope& a, const Slope& b);
Slope operator/(const Slope& a, const Slope& b);

Slope square(const Slope& a);
Slope sqrt(const Slope& a);
Slope acos(const Slope& a);
Slope atan(const Slope& a);
Slope abs(const Slope& a);
Slope min(const Slope& a, const Slope& b);
Slope max(const Slope& a, const Slope& b);
/// Requires values within (-pi, pi); beyond a quarter turn the enclosure is [-1, 1].
Slope sin(const Slope& a);
Slope cos(const Slope& a);
Slope exp(const Slope& a);
/// Requires positive values; nothing is known where some are not.
Slope log(const Slope& a);

/// t - atan(t): the involute of an angle by its tangent, for t >= 0.
Slope involute_of(const Slope& tangent);
/// The tangent whose involute it is; of what is negative, nothing.
Slope tangent_of_involute(const Slope& involute);

/// The same for numbers, so that one formula serves both.
double involute_of(double tangent);
double tangent_of_involute(double involute);

/// theta = g tan(theta) - h, the angle at the root fillet of DIN 3990-3, for |g| far below 1.
double root_angle_rad(double g, double h);
Slope root_angle_rad(const Slope& g, const Slope& h);

/// The rounding that takes all of the land of a shaper's tip (docs/derivations/tooth_outline.md
/// eq. (13)), by the radius of its tip; `half_land_rad` is pi/(2 z) + inv(alpha).
/// At most `most`.
double full_rounding(double tip, double base, double half_land_rad, double most);
Slope full_rounding(const Slope& tip, double base, double half_land_rad, double most);

}  // namespace torquewright::gearbox
