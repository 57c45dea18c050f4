// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace torquewright::gearbox::sized {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The variables of a layer: centre distance [mm], shift of its planet [modules].
inline constexpr std::size_t kVariables = 2;

/// Far more than the rounding of a few operations, relative to their terms.
inline constexpr double kRounding = 0x1p-50;

/// A function over a box as affine arithmetic has it: center + slope . e + something of at most
/// `rest`, where e runs from -1 to 1 with each variable, and between `low` and `high` besides.
/// Outward rounded. Points at which the function does not exist are left out: low > high says that
/// it exists nowhere.
struct Affine {
  double center = 0.0;
  std::array<double, kVariables> slope{};
  double rest = 0.0;
  double low = 0.0, high = 0.0;

  Affine() = default;
  Affine(double number) : center(number), low(number), high(number) {}  // NOLINT: a number is one

  bool is_nowhere() const { return low > high; }
  /// How far center + slope . e + rest may be from 0.
  double size() const { return std::abs(center) + std::abs(slope[0]) + std::abs(slope[1]) + rest; }
};

inline Affine nowhere() {
  Affine none;
  none.low = kInfinity;
  none.high = -kInfinity;
  return none;
}

/// What the two descriptions leave of each other. Every operation ends with it.
inline Affine settled(Affine x) {
  const double reach = std::abs(x.slope[0]) + std::abs(x.slope[1]) + x.rest;
  if (reach < kInfinity && std::abs(x.center) < kInfinity) {
    const double outward = reach + kRounding * (reach + std::abs(x.center));
    if (x.center - outward > x.low) x.low = x.center - outward;
    if (x.center + outward < x.high) x.high = x.center + outward;
    if (!(x.low > -kInfinity)) x.low = x.center - outward;
    if (!(x.high < kInfinity)) x.high = x.center + outward;
    if (x.low > x.high) return nowhere();
    if (!(0.5 * (x.high - x.low) < x.rest)) return x;
  } else {
    if (!(x.low > -kInfinity)) x.low = -kInfinity;
    if (!(x.high < kInfinity)) x.high = kInfinity;
  }
  // The range alone says more.
  x.slope = {};
  x.center = 0.5 * (x.low + x.high);
  x.rest = 0.5 * (x.high - x.low) * (1.0 + kRounding) + kRounding * std::abs(x.center);
  if (!(x.rest < kInfinity)) {
    x.center = 0.0;
    x.rest = kInfinity;
  }
  return x;
}

inline double down(double value) { return value - (std::abs(value) * kRounding + 0x1p-1022); }
inline double up(double value) { return value + (std::abs(value) * kRounding + 0x1p-1022); }

inline Affine operator-(const Affine& a) {
  Affine x = a;
  x.center = -a.center;
  x.slope = {-a.slope[0], -a.slope[1]};
  x.low = -a.high;
  x.high = -a.low;
  return x;
}

inline Affine operator+(const Affine& a, const Affine& b) {
  if (a.is_nowhere()) return a;
  if (b.is_nowhere()) return b;
  Affine x;
  x.center = a.center + b.center;
  x.slope = {a.slope[0] + b.slope[0], a.slope[1] + b.slope[1]};
  x.rest = a.rest + b.rest;
  x.rest += kRounding * x.size();
  x.low = down(a.low + b.low);
  x.high = up(a.high + b.high);
  return settled(x);
}

inline Affine operator+(const Affine& a, double b) {
  if (a.is_nowhere()) return a;
  Affine x = a;
  x.center += b;
  x.rest += kRounding * std::abs(x.center);
  x.low = down(a.low + b);
  x.high = up(a.high + b);
  return x;
}

inline Affine operator*(double a, const Affine& b) {
  if (b.is_nowhere()) return b;
  if (!(b.rest < kInfinity) && a == 0.0) return 0.0;
  Affine x;
  x.center = a * b.center;
  x.slope = {a * b.slope[0], a * b.slope[1]};
  x.rest = std::abs(a) * b.rest;
  x.rest += kRounding * x.size();
  x.low = down(a < 0.0 ? a * b.high : a * b.low);
  x.high = up(a < 0.0 ? a * b.low : a * b.high);
  return x;
}

/// Ends of a product of ranges.
struct Ends {
  double low, high;
};
inline Ends product_of_ranges(const Affine& a, const Affine& b) {
  const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
  const double low = std::min(std::min(p, q), std::min(r, s));
  const double high = std::max(std::max(p, q), std::max(r, s));
  // Of infinite ends nothing is known: 0 times infinity is no number.
  if (!(std::abs(p) + std::abs(q) + std::abs(r) + std::abs(s) < kInfinity)) {
    return {-kInfinity, kInfinity};
  }
  return {down(low), up(high)};
}

inline Affine operator*(const Affine& a, const Affine& b) {
  if (a.is_nowhere()) return a;
  if (b.is_nowhere()) return b;
  Affine x;
  const auto& [a0, a1] = a.slope;
  const auto& [b0, b1] = b.slope;
  // e^2 lies between 0 and 1: half of it belongs to the center.
  x.center = a.center * b.center + 0.5 * (a0 * b0 + a1 * b1);
  x.slope = {a.center * b0 + b.center * a0, a.center * b1 + b.center * a1};
  const double size_a = a.size(), size_b = b.size();
  x.rest = 0.5 * (std::abs(a0 * b0) + std::abs(a1 * b1)) + std::abs(a0 * b1 + a1 * b0) +
           (size_a - a.rest) * b.rest + size_b * a.rest + kRounding * size_a * size_b;
  const Ends ends = product_of_ranges(a, b);
  x.low = ends.low;
  x.high = ends.high;
  return settled(x);
}

inline Affine operator-(const Affine& a, const Affine& b) { return a + (-b); }
inline Affine operator+(double a, const Affine& b) { return b + a; }
inline Affine operator-(const Affine& a, double b) { return a + (-b); }
inline Affine operator-(double a, const Affine& b) { return (-b) + a; }
inline Affine operator*(const Affine& a, double b) { return b * a; }

/// The variable itself, over a range of it.
inline Affine variable(double low, double high, std::size_t which) {
  Affine x;
  x.center = 0.5 * (low + high);
  x.slope[which] = 0.5 * (high - low);
  x.rest = kRounding * (std::abs(low) + std::abs(high));
  x.low = low;
  x.high = high;
  return x;
}

Affine reciprocal(const Affine& a);  ///< Where a keeps its sign; else nothing is known of it.
inline Affine operator/(const Affine& a, const Affine& b) { return a * reciprocal(b); }
inline Affine operator/(double a, const Affine& b) { return a * reciprocal(b); }
inline Affine operator/(const Affine& a, double b) { return (1.0 / b) * a; }

// Convex and concave functions lie between the chord of the range and a tangent parallel to it.

Affine squared(const Affine& a);
Affine root(const Affine& a);  ///< Of what is not negative.
Affine exponential(const Affine& a);
Affine logarithm(const Affine& a);  ///< Of what is positive.
Affine arc_cosine(const Affine& a);
Affine arc_tangent(const Affine& a);
Affine sine(const Affine& a);
Affine cosine(const Affine& a);
Affine signed_square(const Affine& a);  ///< a |a|
Affine least(const Affine& a, const Affine& b);
Affine greatest(const Affine& a, const Affine& b);

/// The involute of an angle by its tangent, t - atan(t), for t >= 0; and the tangent by it.
Affine involute(const Affine& tangent);
Affine tangent_of_involute(const Affine& involute);

/// theta = g tan(theta) - h: the angle of the section at 30 degrees, for |g| far below 1.
Affine section_angle_rad(const Affine& g, const Affine& h);

/// The rounding that takes all of the land of a shaper's tip, by the tip's radius; at most `most`.
/// tooth_outline.md eq. (13); `half_land_rad` is pi/(2 q) + inv(alpha).
Affine whole_rounding(const Affine& tip, double base, double half_land_rad, double most);

// The same for numbers: NaN where they do not exist.

inline double squared(double a) { return a * a; }
inline double root(double a) { return std::sqrt(a); }
inline double exponential(double a) { return std::exp(a); }
inline double logarithm(double a) { return std::log(a); }
inline double arc_cosine(double a) { return std::acos(a); }
inline double arc_tangent(double a) { return std::atan(a); }
inline double sine(double a) { return std::sin(a); }
inline double cosine(double a) { return std::cos(a); }
inline double signed_square(double a) { return a * std::abs(a); }
inline double least(double a, double b) { return a < b ? a : b; }
inline double greatest(double a, double b) { return a > b ? a : b; }
inline double involute(double tangent) { return tangent - std::atan(tangent); }
double tangent_of_involute(double involute);
double section_angle_rad(double g, double h);
double whole_rounding(double tip, double base, double half_land_rad, double most);

}  // namespace torquewright::gearbox::sized
