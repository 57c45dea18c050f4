// SPDX-License-Identifier: Apache-2.0
#include "gearbox/sized_proof/enclosures/affine.hpp"

namespace torquewright::gearbox::sized {
namespace {

/// Of <cmath> and of the iterations here: far more than their errors.
constexpr double kError = 1e-14;

double outward_down(double value) { return value - (std::abs(value) * kError + 1e-300); }
double outward_up(double value) { return value + (std::abs(value) * kError + 1e-300); }

/// alpha x + [residual_low, residual_high], with the range beside it.
Affine along(const Affine& x, double alpha, const Ends& residual, const Ends& range) {
  Affine y;
  y.center = alpha * x.center + 0.5 * (residual.low + residual.high);
  y.slope = {alpha * x.slope[0], alpha * x.slope[1]};
  y.rest = std::abs(alpha) * x.rest + 0.5 * (residual.high - residual.low);
  y.rest +=
      4.0 * kRounding *
      (y.size() + std::abs(alpha) * x.size() + std::abs(residual.low) + std::abs(residual.high));
  y.low = range.low;
  y.high = range.high;
  return settled(y);
}

/// Only the range is known.
Affine within(const Ends& range) {
  Affine y;
  y.rest = kInfinity;
  y.low = range.low;
  y.high = range.high;
  return settled(y);
}

/// A function with this range that is convex (else concave) over all of x; `place_of` is where it
/// has a slope.
template <class Function, class Derivative, class Place>
Affine bent_in(const Ends& range, const Affine& x, bool is_convex, const Function& value_of,
               const Derivative& slope_of, const Place& place_of) {
  const double low = x.low, high = x.high;
  const double at_low = value_of(low), at_high = value_of(high);
  const double width = high - low;
  const bool is_narrow = !(width > 1e-7 * (std::abs(low) + std::abs(high)));
  const double alpha = is_narrow ? slope_of(0.5 * (low + high)) : (at_high - at_low) / width;
  const double place = is_narrow ? 0.5 * (low + high) : std::clamp(place_of(alpha), low, high);
  const double at_place = value_of(place), slope = slope_of(place);
  const double chord_low = at_low - alpha * low, chord_high = at_high - alpha * high;
  const double tangent = at_place - alpha * place;
  const double tilt = std::abs(slope - alpha) * width;
  const double error =
      kError * (std::abs(at_low) + std::abs(at_high) + std::abs(at_place) +
                std::abs(alpha) * (std::abs(low) + std::abs(high)) + std::abs(slope) * width);
  Ends residual = is_convex ? Ends{tangent - tilt, std::max(chord_low, chord_high)}
                            : Ends{std::min(chord_low, chord_high), tangent + tilt};
  if (residual.low > residual.high) std::swap(residual.low, residual.high);
  return along(x, alpha, {residual.low - error, residual.high + error}, range);
}

template <class Function>
Ends range_of(const Affine& x, const Function& value_of) {
  const double a = value_of(x.low), b = value_of(x.high);
  return {outward_down(std::min(a, b)), outward_up(std::max(a, b))};
}

/// The same of a monotone function.
template <class Function, class Derivative, class Place>
Affine bent(const Affine& x, bool is_convex, const Function& value_of, const Derivative& slope_of,
            const Place& place_of) {
  return bent_in(range_of(x, value_of), x, is_convex, value_of, slope_of, place_of);
}

/// A function whose derivative lies in a range: a line through the middle with its mean slope.
template <class Function>
Affine sloped(const Affine& x, const Function& value_of, const Ends& slope, const Ends& range) {
  const double middle = 0.5 * (x.low + x.high), half = 0.5 * (x.high - x.low);
  const double alpha = 0.5 * (slope.low + slope.high);
  const double at_middle = value_of(middle);
  const double spread = 0.5 * (slope.high - slope.low) * half;
  const double error = kError * (std::abs(at_middle) + std::abs(alpha) * (std::abs(middle) + half));
  const double residual = at_middle - alpha * middle;
  return along(x, alpha, {residual - spread - error, residual + spread + error}, range);
}

/// What of x lies at or above a bound; nowhere if nothing does.
Affine from(const Affine& x, double bound) {
  if (x.low >= bound || x.is_nowhere()) return x;
  if (x.high < bound) return nowhere();
  Affine part = x;
  part.low = bound;
  return part;
}

}  // namespace

Affine reciprocal(const Affine& a) {
  if (a.is_nowhere()) return a;
  if (a.high < 0.0) return -reciprocal(-a);
  if (!(a.low > 0.0) || !(a.high < kInfinity)) return within({-kInfinity, kInfinity});
  return bent(
      a, true, [](double x) { return 1.0 / x; }, [](double x) { return -1.0 / (x * x); },
      [](double s) { return std::sqrt(-1.0 / s); });
}

Affine squared(const Affine& a) {
  if (a.is_nowhere()) return a;
  Affine x = a * a;
  if (x.low < 0.0) x.low = 0.0;
  return x;
}

Affine root(const Affine& a) {
  const Affine x = from(a, 0.0);
  if (x.is_nowhere()) return x;
  if (!(x.high < kInfinity)) return within({std::sqrt(x.low), kInfinity});
  if (x.high == 0.0) return 0.0;
  return bent(
      x, false, [](double v) { return std::sqrt(v); }, [](double v) { return 0.5 / std::sqrt(v); },
      [](double s) { return 0.25 / (s * s); });
}

Affine exponential(const Affine& a) {
  if (a.is_nowhere()) return a;
  const auto value = [](double x) { return std::exp(x); };
  if (!(a.high < 700.0) || !(a.low > -700.0)) return within({0.0, outward_up(std::exp(a.high))});
  return bent(a, true, value, value, [](double s) { return std::log(s); });
}

Affine logarithm(const Affine& a) {
  const Affine x = from(a, 0.0);
  if (x.is_nowhere()) return x;
  if (!(x.low > 0.0) || !(x.high < kInfinity)) {
    return within({-kInfinity, outward_up(std::log(x.high))});
  }
  return bent(
      x, false, [](double v) { return std::log(v); }, [](double v) { return 1.0 / v; },
      [](double s) { return 1.0 / s; });
}

Affine arc_cosine(const Affine& a) {
  if (a.is_nowhere()) return a;
  if (a.low > 1.0 || a.high < -1.0) return nowhere();
  Affine x = a;
  x.low = std::max(x.low, -1.0);
  x.high = std::min(x.high, 1.0);
  const auto value = [](double v) { return std::acos(v); };
  const auto slope = [](double v) { return -1.0 / std::sqrt((1.0 - v) * (1.0 + v)); };
  const auto place = [](double s) { return std::sqrt(std::max(0.0, 1.0 - 1.0 / (s * s))); };
  if (x.low >= 0.0 && x.high < 1.0) return bent(x, false, value, slope, place);
  if (x.high <= 0.0 && x.low > -1.0) {
    return bent(x, true, value, slope, [&](double s) { return -place(s); });
  }
  const Ends range = range_of(x, value);
  if (!(x.low > -1.0) || !(x.high < 1.0)) return within(range);
  const double steepest = std::min(slope(x.low), slope(x.high));
  return sloped(x, value, {outward_down(steepest), -1.0}, range);
}

Affine arc_tangent(const Affine& a) {
  if (a.is_nowhere()) return a;
  const auto value = [](double x) { return std::atan(x); };
  const auto slope = [](double x) { return 1.0 / (1.0 + x * x); };
  if (!(a.high - a.low < kInfinity)) return within({-kPi / 2.0 - 1e-15, kPi / 2.0 + 1e-15});
  if (a.low >= 0.0) {
    return bent(a, false, value, slope,
                [](double s) { return std::sqrt(std::max(0.0, 1.0 / s - 1.0)); });
  }
  if (a.high <= 0.0) return -arc_tangent(-a);
  const double flattest = std::min(slope(a.low), slope(a.high));
  return sloped(a, value, {outward_down(flattest), 1.0}, range_of(a, value));
}

Affine sine(const Affine& a) {
  if (a.is_nowhere()) return a;
  if (!(a.low >= -kPi / 2.0) || !(a.high <= kPi / 2.0)) return within({-1.0, 1.0});
  const auto value = [](double x) { return std::sin(x); };
  const auto slope = [](double x) { return std::cos(x); };
  const auto place = [](double s) { return std::acos(std::clamp(s, -1.0, 1.0)); };
  if (a.low >= 0.0) return bent(a, false, value, slope, place);
  if (a.high <= 0.0) {
    return bent(a, true, value, slope, [&](double s) { return -place(s); });
  }
  const double flattest = std::min(slope(a.low), slope(a.high));
  return sloped(a, value, {outward_down(flattest), 1.0}, range_of(a, value));
}

Affine cosine(const Affine& a) {
  if (a.is_nowhere()) return a;
  if (!(a.low >= -kPi / 2.0) || !(a.high <= kPi / 2.0)) return within({-1.0, 1.0});
  const auto value = [](double x) { return std::cos(x); };
  const auto slope = [](double x) { return -std::sin(x); };
  Ends range = range_of(a, value);
  if (a.low < 0.0 && a.high > 0.0) range.high = 1.0;
  return bent_in(range, a, false, value, slope,
                 [](double s) { return -std::asin(std::clamp(s, -1.0, 1.0)); });
}

Affine signed_square(const Affine& a) {
  if (a.is_nowhere()) return a;
  if (a.low >= 0.0) return squared(a);
  if (a.high <= 0.0) return -squared(a);
  const double steepest = outward_up(2.0 * std::max(-a.low, a.high));
  const auto value = [](double x) { return x * std::abs(x); };
  return sloped(a, value, {0.0, steepest}, range_of(a, value));
}

Affine least(const Affine& a, const Affine& b) {
  if (a.is_nowhere()) return a;
  if (b.is_nowhere()) return b;
  if (a.high <= b.low) return a;
  if (b.high <= a.low) return b;
  const Ends range{std::min(a.low, b.low), std::min(a.high, b.high)};
  const Affine d = a - b;
  if (!(d.low < 0.0) || !(d.high > 0.0) || !(d.rest < kInfinity)) return within(range);
  // |d| = s d + [0, w] with the chord's slope s and its height w at 0.
  const double s = (d.high + d.low) / (d.high - d.low);
  const double w = -2.0 * d.low * d.high / (d.high - d.low);
  if (!(std::abs(s) + w < kInfinity)) return within(range);
  Affine y = 0.5 * (a + b) - (0.5 * s) * d;
  y.center -= 0.25 * w;
  y.rest += 0.25 * w + kError * (w + std::abs(s) * d.size());
  y.low = range.low;
  y.high = range.high;
  return settled(y);
}

Affine greatest(const Affine& a, const Affine& b) { return -least(-a, -b); }

Affine involute(const Affine& tangent) {
  const Affine t = from(tangent, 0.0);
  if (t.is_nowhere()) return t;
  const auto value = [](double x) { return x - std::atan(x); };
  if (!(t.high < kInfinity)) return within({outward_down(value(t.low)) - 1e-17, kInfinity});
  Affine y = bent(
      t, true, value, [](double x) { return x * x / (1.0 + x * x); },
      [](double s) { return std::sqrt(s / std::max(1e-300, 1.0 - s)); });
  // The difference of tangent and angle loses digits of the angle.
  const double lost = kError * (t.high + 1.0);
  y.rest += lost;
  y.low -= lost;
  y.high += lost;
  return y;
}

double tangent_of_involute(double value) {
  if (!(value >= 0.0) || !(value < kInfinity)) return std::nan("");
  if (value == 0.0) return 0.0;
  // t - atan(t) lies between t^3/3 - t^5/5 and t - pi/2: Halley's steps on it.
  double t = value < 0.5 ? std::cbrt(3.0 * value) : value + kPi / 2.0;
  for (int step = 0; step < 40; ++step) {
    const double miss = t - std::atan(t) - value;
    const double first = t * t / (1.0 + t * t);
    const double second = 2.0 * t / ((1.0 + t * t) * (1.0 + t * t));
    const double change = miss / (first - 0.5 * miss * second / first);
    t -= change;
    if (!(std::abs(change) > 1e-15 * t)) break;
  }
  return t;
}

Affine tangent_of_involute(const Affine& involute_range) {
  const Affine v = from(involute_range, 0.0);
  if (v.is_nowhere()) return v;
  if (!(v.high < kInfinity) || !(v.low > 1e-9)) {
    return within({0.0, v.high < kInfinity ? tangent_of_involute(v.high) * (1.0 + 1e-9) : v.high});
  }
  Affine y = bent(
      v, false, [](double x) { return tangent_of_involute(x); },
      [](double x) {
        const double t = tangent_of_involute(x);
        return 1.0 + 1.0 / (t * t);
      },
      [](double s) {
        const double t = 1.0 / std::sqrt(std::max(1e-12, s - 1.0));
        return t - std::atan(t);
      });
  // Digits of the involute that its difference lost.
  const double t = tangent_of_involute(v.low);
  const double lost = 10.0 * kError * (1.0 + 1.0 / (t * t));
  y.rest += lost;
  y.low -= lost;
  y.high += lost;
  return y;
}

double section_angle_rad(double g, double h) {
  double angle = kPi / 6.0;
  for (int step = 0; step < 60; ++step) {
    const double t = std::tan(angle);
    const double change = (angle - g * t + h) / (1.0 - g * (1.0 + t * t));
    angle -= change;
    if (!(std::abs(change) > 1e-15)) break;
  }
  return angle;
}

Affine section_angle_rad(const Affine& g, const Affine& h) {
  if (g.is_nowhere()) return g;
  if (h.is_nowhere()) return h;
  if (!(g.rest + h.rest < kInfinity)) return within({-kInfinity, kInfinity});
  // It grows with g and falls with h, as long as the tangent is positive and 1 > g/cos^2.
  const Ends range{section_angle_rad(g.low, h.high) - 1e-12,
                   section_angle_rad(g.high, h.low) + 1e-12};
  if (!(range.low > 0.0 && range.high < 1.3)) return within({-kInfinity, kInfinity});
  const double g0 = g.center, h0 = h.center, theta = section_angle_rad(g0, h0);
  const double t = std::tan(theta), secant = 1.0 + t * t;
  const double farthest_t = outward_up(std::tan(std::max(range.high, theta)));
  if (!(std::max(g.high, g0) * (1.0 + farthest_t * farthest_t) < 0.9)) {
    return within({-kInfinity, kInfinity});
  }
  // theta' = theta + d: d (1 - g sec) = (g - g0) t - (h - h0) + g R - residual, R the rest of the
  // tangent's expansion, tan'' d^2/2.
  const double reach = outward_up(std::max(range.high - theta, theta - range.low));
  const double bent_by = farthest_t * (1.0 + farthest_t * farthest_t) * reach * reach;
  Affine rest;
  rest.center = 0.5 * bent_by;
  rest.rest = 0.5 * bent_by * (1.0 + 1e-12);
  rest.low = 0.0;
  rest.high = bent_by * (1.0 + 1e-12);
  const double residual = std::abs(theta - g0 * t + h0) + 1e-15;
  Affine numerator = t * (g - g0) - (h - h0) + g * rest;
  numerator.rest += residual;
  numerator.low -= residual;
  numerator.high += residual;
  Affine y = theta + numerator / (1.0 - secant * g);
  y.low = std::max(y.low, range.low);
  y.high = std::min(y.high, range.high);
  return settled(y);
}

double whole_rounding(double tip, double base, double half_land_rad, double most) {
  const auto land_rad = [&](double rounding) {
    const double arm = tip - rounding;
    if (!(arm > base)) return -1.0;
    const double tangent = std::sqrt((arm - base) * (arm + base)) / base;
    return half_land_rad - (tangent - std::atan(tangent)) - rounding / base;
  };
  if (!(land_rad(0.0) > 0.0)) return 0.0;
  if (land_rad(most) > 0.0) return most;
  // The secant between both ends, kept inside by halving when it lags.
  double inside = 0.0, outside = most;
  double at_inside = land_rad(inside), at_outside = land_rad(outside);
  for (int step = 0; step < 100 && outside - inside > 1e-15; ++step) {
    const bool is_halving = step % 3 == 2 || !(at_inside > at_outside);
    double trial = is_halving ? 0.5 * (inside + outside)
                              : inside + (outside - inside) * at_inside / (at_inside - at_outside);
    trial = std::clamp(trial, inside + 1e-16, std::max(inside + 1e-16, outside - 1e-16));
    const double at = land_rad(trial);
    (at > 0.0 ? inside : outside) = trial;
    (at > 0.0 ? at_inside : at_outside) = at;
  }
  return inside;
}

Affine whole_rounding(const Affine& tip, double base, double half_land_rad, double most) {
  if (tip.is_nowhere()) return tip;
  // The farther out the tip, the less land there is to take. Its slope is -s/(1 - s), s the sine of
  // the profile angle at the rounding's centre.
  const Ends range{whole_rounding(tip.high, base, half_land_rad, most) - 1e-13,
                   whole_rounding(tip.low, base, half_land_rad, most) + 1e-13};
  if (range.low >= most - 1e-12) return most;
  if (!(range.low > 1e-12) || !(range.high < most) || !(tip.low - range.high > base)) {
    return within(range);
  }
  const auto slope_at = [&](double arm) {
    const double sine = std::sqrt((arm - base) * (arm + base)) / arm;
    return -sine / (1.0 - sine);
  };
  const Ends slope{outward_down(slope_at(tip.high - range.low)),
                   outward_up(slope_at(tip.low - range.high))};
  const auto value = [&](double x) { return whole_rounding(x, base, half_land_rad, most); };
  Affine y = sloped(tip, value, slope, range);
  y.rest += 1e-12;
  return y;
}

}  // namespace torquewright::gearbox::sized
