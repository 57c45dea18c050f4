// SPDX-License-Identifier: Apache-2.0
#include "gearbox/synthesis/slope.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace torquewright::gearbox {
namespace {

using optimization::kInfinity;

const Interval kWholeLine{-kInfinity, kInfinity};

/// Of <cmath> and of iterations here: far more than their errors of some units in the last place.
constexpr double kWider = 1e-14;

Interval wider(double low, double high) {
  return {low - (std::abs(low) * kWider + 1e-300), high + (std::abs(high) * kWider + 1e-300)};
}

inline bool is_zero(const Interval& a) { return a.lower == 0.0 && a.upper == 0.0; }

// The operations of optimization/expressions/interval.hpp on finite intervals, here for the
// compiler to see: a search makes some hundred million of them. What is not finite goes there.
inline double down(double value) { return value - (std::abs(value) * 0x1p-51 + 0x1p-1022); }
inline double up(double value) { return value + (std::abs(value) * 0x1p-51 + 0x1p-1022); }

inline Interval negative(const Interval& a) { return {-a.upper, -a.lower}; }

inline bool is_finite(const Interval& a) { return a.upper - a.lower < kInfinity; }

inline Interval sum(const Interval& a, const Interval& b) {
  const Interval result{down(a.lower + b.lower), up(a.upper + b.upper)};
  return is_finite(result) ? result : a + b;
}

inline Interval product(const Interval& a, const Interval& b) {
  if (!is_finite(a) || !is_finite(b)) return a * b;
  const double p = a.lower * b.lower, q = a.lower * b.upper;
  const double r = a.upper * b.lower, s = a.upper * b.upper;
  const double low = std::min(std::min(p, q), std::min(r, s));
  const double high = std::max(std::max(p, q), std::max(r, s));
  const Interval result{down(low), up(high)};
  return is_finite(result) ? result : a * b;
}

Interval hull(const Interval& a, const Interval& b) {
  return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}

/// What the slopes leave of the value.
void tighten(Slope& result) {
  if (result.offsets == nullptr) return;
  Interval linear = result.center;
  for (std::size_t i = 0; i < kInnerVariables; ++i) {
    if (is_zero(result.slopes[i])) continue;
    linear = sum(linear, product(result.slopes[i], (*result.offsets)[i]));
  }
  // Comparisons with NaN fail: then nothing is known.
  if (linear.lower > result.value.lower) result.value.lower = linear.lower;
  if (linear.upper < result.value.upper) result.value.upper = linear.upper;
}

/// Chain rule for a function of one argument.
Slope chained(const Slope& a, const Interval& value, const Interval& center,
              const Interval& derivative) {
  Slope result;
  result.value = value;
  result.center = center;
  result.offsets = a.offsets;
  for (std::size_t i = 0; i < kInnerVariables; ++i) {
    if (!is_zero(a.slopes[i])) result.slopes[i] = product(derivative, a.slopes[i]);
  }
  tighten(result);
  return result;
}

Slope with_unknown_slopes(const Slope& a, const Interval& value, const Interval& center) {
  Slope result;
  result.value = value;
  result.center = center;
  result.offsets = a.offsets;
  for (std::size_t i = 0; i < kInnerVariables; ++i) {
    if (!is_zero(a.slopes[i])) result.slopes[i] = kWholeLine;
  }
  return result;
}

const InnerBox* offsets_of(const Slope& a, const Slope& b) {
  return a.offsets != nullptr ? a.offsets : b.offsets;
}

Interval tangent_of_involute_range(const Interval& involute) {
  const double low = std::max(0.0, involute.lower);
  return {std::max(0.0, tangent_of_involute(low) * (1.0 - 1e-12) - 1e-12),
          tangent_of_involute(std::max(low, involute.upper)) * (1.0 + 1e-12) + 1e-12};
}

}  // namespace

InnerPlace::InnerPlace(const InnerBox& box) : box_(box) {
  for (std::size_t i = 0; i < kInnerVariables; ++i) {
    middle_[i] = box[i].middle();
    offsets_[i] = box[i] - Interval(middle_[i]);
  }
}

Slope InnerPlace::variable(std::size_t which) const {
  Slope variable;
  variable.value = box_[which];
  variable.center = middle_[which];
  variable.slopes[which] = 1.0;
  variable.offsets = &offsets_;
  return variable;
}

Slope operator-(const Slope& a) {
  Slope result;
  result.value = negative(a.value);
  result.center = negative(a.center);
  result.offsets = a.offsets;
  for (std::size_t i = 0; i < kInnerVariables; ++i) result.slopes[i] = negative(a.slopes[i]);
  return result;
}

Slope operator+(const Slope& a, const Slope& b) {
  Slope result;
  result.value = sum(a.value, b.value);
  result.center = sum(a.center, b.center);
  result.offsets = offsets_of(a, b);
  for (std::size_t i = 0; i < kInnerVariables; ++i) {
    result.slopes[i] = is_zero(a.slopes[i])   ? b.slopes[i]
                       : is_zero(b.slopes[i]) ? a.slopes[i]
                                              : sum(a.slopes[i], b.slopes[i]);
  }
  if (a.offsets != nullptr && b.offsets != nullptr) tighten(result);
  return result;
}

Slope operator-(const Slope& a, const Slope& b) { return a + (-b); }

Slope operator*(const Slope& a, const Slope& b) {
  Slope result;
  result.value = product(a.value, b.value);
  result.center = product(a.center, b.center);
  result.offsets = offsets_of(a, b);
  // One factor at the middle is enough: a(x) b(x) - a(c) b(c) = (a(x) - a(c)) b(x) + a(c) (b(x) -
  // b(c)).
  for (std::size_t i = 0; i < kInnerVariables; ++i) {
    const bool has_a = !is_zero(a.slopes[i]), has_b = !is_zero(b.slopes[i]);
    if (has_a && has_b) {
      result.slopes[i] = sum(product(a.slopes[i], b.value), product(a.value, b.slopes[i]));
    } else if (has_a) {
      result.slopes[i] = product(a.slopes[i], b.value);
    } else if (has_b) {
      result.slopes[i] = product(a.value, b.slopes[i]);
    }
  }
  if (a.offsets != nullptr && b.offsets != nullptr) tighten(result);
  return result;
}

Slope operator/(const Slope& a, const Slope& b) {
  const Interval reciprocal = Interval(1.0) / b.value;
  return a * chained(b, reciprocal, Interval(1.0) / b.center,
                     negative(optimization::square(reciprocal)));
}

Slope square(const Slope& a) {
  return chained(a, optimization::square(a.value), optimization::square(a.center),
                 Interval(2.0) * a.value);
}

Slope sqrt(const Slope& a) {
  const Interval root = optimization::sqrt(a.value), center = optimization::sqrt(a.center);
  if (!(a.value.lower > 0.0)) return with_unknown_slopes(a, root, center);
  return chained(a, root, center, Interval(0.5) / root);
}

Slope acos(const Slope& a) {
  const Interval angle = optimization::acos(a.value), center = optimization::acos(a.center);
  if (!(a.value.lower > -1.0) || !(a.value.upper < 1.0)) {
    return with_unknown_slopes(a, angle, center);
  }
  const Interval sine = optimization::sqrt(Interval(1.0) - optimization::square(a.value));
  return chained(a, angle, center, Interval(-1.0) / sine);
}

Slope atan(const Slope& a) {
  return chained(a, optimization::atan(a.value), optimization::atan(a.center),
                 Interval(1.0) / (Interval(1.0) + optimization::square(a.value)));
}

Slope abs(const Slope& a) {
  const Interval sign = a.value.lower >= 0.0   ? Interval(1.0)
                        : a.value.upper <= 0.0 ? Interval(-1.0)
                                               : Interval(-1.0, 1.0);
  return chained(a, optimization::abs(a.value), optimization::abs(a.center), sign);
}

Slope min(const Slope& a, const Slope& b) {
  if (a.value.upper <= b.value.lower) return a;
  if (b.value.upper <= a.value.lower) return b;
  Slope result;
  result.value = optimization::min(a.value, b.value);
  result.center = optimization::min(a.center, b.center);
  result.offsets = offsets_of(a, b);
  for (std::size_t i = 0; i < kInnerVariables; ++i) {
    result.slopes[i] = hull(a.slopes[i], b.slopes[i]);
  }
  tighten(result);
  return result;
}

Slope max(const Slope& a, const Slope& b) { return -min(-a, -b); }

namespace {

double farthest(const Interval& a) { return std::max(std::abs(a.lower), std::abs(a.upper)); }

double nearest(const Interval& a) {
  return a.contains(0.0) ? 0.0 : std::min(std::abs(a.lower), std::abs(a.upper));
}

Interval sine_of(const Interval& a) { return wider(std::sin(a.lower), std::sin(a.upper)); }

Interval cosine_of(const Interval& a) { return wider(std::cos(farthest(a)), std::cos(nearest(a))); }

/// Within a quarter turn, where the sine grows and the cosine falls to both sides.
constexpr double kQuarter_rad = 1.57;

}  // namespace

Slope sin(const Slope& a) {
  if (!(farthest(a.value) <= kQuarter_rad)) return with_unknown_slopes(a, {-1.0, 1.0}, {-1.0, 1.0});
  return chained(a, sine_of(a.value), sine_of(a.center), cosine_of(a.value));
}

Slope cos(const Slope& a) {
  if (!(farthest(a.value) <= kQuarter_rad)) return with_unknown_slopes(a, {-1.0, 1.0}, {-1.0, 1.0});
  return chained(a, cosine_of(a.value), cosine_of(a.center), -sine_of(a.value));
}

Slope exp(const Slope& a) {
  const auto of = [](const Interval& x) { return wider(std::exp(x.lower), std::exp(x.upper)); };
  const Interval value = of(a.value);
  return chained(a, value, of(a.center), value);
}

Slope log(const Slope& a) {
  const auto of = [](const Interval& x) { return wider(std::log(x.lower), std::log(x.upper)); };
  if (!(a.value.lower > 0.0)) return with_unknown_slopes(a, kWholeLine, kWholeLine);
  return chained(a, of(a.value), of(a.center), Interval(1.0) / a.value);
}

double involute_of(double tangent) { return tangent - std::atan(tangent); }

Slope involute_of(const Slope& tangent) {
  const auto of = [](const Interval& x) {
    return Interval{involute_of(x.lower) - (std::abs(x.lower) * kWider + 1e-300),
                    involute_of(x.upper) + (std::abs(x.upper) * kWider + 1e-300)};
  };
  const Interval squared = optimization::square(tangent.value);
  return chained(tangent, of(tangent.value), of(tangent.center),
                 squared / (Interval(1.0) + squared));
}

double tangent_of_involute(double involute) {
  if (!(involute >= 0.0) || !std::isfinite(involute)) return std::nan("");
  // Newton on t - atan(t) = involute, from above: it descends and never crosses.
  double tangent =
      std::max(std::cbrt(3.0 * involute), involute) + std::min(involute, std::numbers::pi / 2);
  for (int step = 0; step < 60 && tangent > 0.0; ++step) {
    const double excess = involute_of(tangent) - involute;
    const double next = tangent - excess * (1.0 + tangent * tangent) / (tangent * tangent);
    if (!(next < tangent)) break;
    tangent = next;
  }
  return tangent;
}

Slope tangent_of_involute(const Slope& involute) {
  const Interval tangent = tangent_of_involute_range(involute.value);
  const Interval center = tangent_of_involute_range(involute.center);
  if (!(tangent.lower > 0.0)) return with_unknown_slopes(involute, tangent, center);
  const Interval squared = optimization::square(tangent);
  return chained(involute, tangent, center, (Interval(1.0) + squared) / squared);
}

double root_angle_rad(double g, double h) {
  // Newton on theta - g tan(theta) + h from where strength.hpp begins.
  double angle = std::numbers::pi / 6.0;
  for (int step = 0; step < 50; ++step) {
    const double tangent = std::tan(angle);
    const double change = (angle - g * tangent + h) / (1.0 - g * (1.0 + tangent * tangent));
    angle -= change;
    if (!(std::abs(change) > 1e-15)) break;
  }
  return angle;
}

Slope root_angle_rad(const Slope& g, const Slope& h) {
  // It grows with g and falls with h: tan(theta) > 0 and 1 - g/cos^2(theta) > 0.
  const auto of = [](const Interval& at_g, const Interval& at_h) {
    return Interval{root_angle_rad(at_g.lower, at_h.upper) - 1e-12,
                    root_angle_rad(at_g.upper, at_h.lower) + 1e-12};
  };
  Slope result;
  result.value = of(g.value, h.value);
  result.center = of(g.center, h.center);
  result.offsets = offsets_of(g, h);
  if (!(result.value.lower > 0.0 && result.value.upper < 1.3)) {
    return with_unknown_slopes(g + h, kWholeLine, kWholeLine);
  }
  const Interval tangent = wider(std::tan(result.value.lower), std::tan(result.value.upper));
  const Interval slope = Interval(1.0) - g.value * (Interval(1.0) + optimization::square(tangent));
  if (!(slope.lower > 0.0)) return with_unknown_slopes(g + h, kWholeLine, kWholeLine);
  for (std::size_t i = 0; i < kInnerVariables; ++i) {
    if (is_zero(g.slopes[i]) && is_zero(h.slopes[i])) continue;
    result.slopes[i] = (tangent * g.slopes[i] - h.slopes[i]) / slope;
  }
  tighten(result);
  return result;
}

double full_rounding(double tip, double base, double half_land_rad, double most) {
  const auto land_rad = [&](double rounding) {
    const double center = tip - rounding;
    if (center <= base) return -1.0;
    const double tangent = std::sqrt(center * center - base * base) / base;
    return half_land_rad - involute_of(tangent) - rounding / base;
  };
  if (!(land_rad(0.0) > 0.0)) return 0.0;
  if (land_rad(most) > 0.0) return most;
  double inside = 0.0, outside = most;
  double trial = 0.5 * most;
  for (int step = 0; step < 60 && outside - inside > 1e-15; ++step) {
    const double land = land_rad(trial);
    (land > 0.0 ? inside : outside) = trial;
    const double center = tip - trial;
    const double sine = center > base ? std::sqrt(1.0 - base / center * (base / center)) : 1.0;
    const double next = trial + land * base / (1.0 - sine);  // Newton, within what is known.
    if (std::abs(next - trial) < 1e-16) break;
    trial = next > inside && next < outside ? next : 0.5 * (inside + outside);
  }
  return trial;
}

Slope full_rounding(const Slope& tip, double base, double half_land_rad, double most) {
  // d(rounding)/d(tip) = -s/(1 - s), s the sine of the profile angle at the rounding's centre.
  const auto of = [&](const Interval& at_tip) {
    return Interval{full_rounding(at_tip.upper, base, half_land_rad, most) - 1e-12,
                    full_rounding(at_tip.lower, base, half_land_rad, most) + 1e-12};
  };
  const Interval rounding = of(tip.value);
  if (rounding.lower >= most - 2e-12) return most;
  if (rounding.upper > most) return with_unknown_slopes(tip, rounding, of(tip.center));
  const Interval center = tip.value - rounding;
  const Interval cosine = optimization::min(Interval(base) / center, 1.0);
  const Interval sine = optimization::sqrt(Interval(1.0) - optimization::square(cosine));
  if (!(rounding.lower > 0.0) || !(center.lower > base) || !(sine.upper < 1.0)) {
    return with_unknown_slopes(tip, rounding, of(tip.center));
  }
  return chained(tip, rounding, of(tip.center), -sine / (Interval(1.0) - sine));
}

}  // namespace torquewright::gearbox
