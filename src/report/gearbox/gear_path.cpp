// SPDX-License-Identifier: Apache-2.0
#include "src/report/gearbox/gear_path.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "gearbox/teeth/tooth_outline.hpp"
#include "src/report/parts/svg.hpp"

namespace torquewright::report {
namespace {

using gearbox::OutlineCurve;

constexpr double kFlankTolerance = 2e-7;  // Modules.
constexpr double kRootTolerance = 2e-5;   // Modules; tips and roots keep clear of the mate.
constexpr int kMaxHalvings = 10;
constexpr double kStepsPerMillimetre = 1e6;

using Cubic = std::array<Point, 4>;

Point combined(const std::array<double, 4>& weights, const Cubic& points) {
  Point sum;
  for (std::size_t i = 0; i < 4; ++i) {
    sum.x += weights[i] * points[i].x;
    sum.y += weights[i] * points[i].y;
  }
  return sum;
}

// The cubic through the curve at 0, 1/3, 2/3 and 1 of the interval, by its control points.
Cubic interpolated(const OutlineCurve& curve, double from, double to) {
  const double third = (to - from) / 3.0;
  const Cubic on_curve{curve.point(from), curve.point(from + third), curve.point(to - third),
                       curve.point(to)};
  return {on_curve[0], combined({-5.0 / 6.0, 3.0, -1.5, 1.0 / 3.0}, on_curve),
          combined({1.0 / 3.0, -1.5, 3.0, -5.0 / 6.0}, on_curve), on_curve[3]};
}

Point on_cubic(const Cubic& cubic, double t) {
  const double s = 1.0 - t;
  return combined({s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t}, cubic);
}

// Measured where the error of a cubic interpolation is largest.
double error_of(const Cubic& cubic, const OutlineCurve& curve, double from, double to) {
  double error = 0.0;
  for (const double t : {0.127, 0.5, 0.873}) {
    const Point approximate = on_cubic(cubic, t);
    const Point exact = curve.point(from + t * (to - from));
    error = std::fmax(error, std::hypot(approximate.x - exact.x, approximate.y - exact.y));
  }
  return error;
}

void append_cubics(const OutlineCurve& curve, double from, double to, int halvings,
                   std::vector<Cubic>& cubics) {
  const double tolerance = curve.is_flank ? kFlankTolerance : kRootTolerance;
  const Cubic cubic = interpolated(curve, from, to);
  if (halvings == 0 || error_of(cubic, curve, from, to) <= tolerance) {
    cubics.push_back(cubic);
    return;
  }
  const double middle = 0.5 * (from + to);
  append_cubics(curve, from, middle, halvings - 1, cubics);
  append_cubics(curve, middle, to, halvings - 1, cubics);
}

// Writes relative coordinates against the rounded pen, so that rounding does not add up.
class PathPen {
 public:
  explicit PathPen(double paper_mm_per_module)
      : steps_per_module_(paper_mm_per_module * kStepsPerMillimetre) {}

  void move(const Point& point) {
    data_ = 'M';
    append(point);
    pen_ = rounded(point);
  }

  void curve(const Point& first, const Point& second, const Point& end) {
    data_ += 'c';
    append(first);
    data_ += ' ';
    append(second);
    data_ += ' ';
    append(end);
    pen_ = rounded(end);
  }

  std::string closed() const { return data_ + 'Z'; }

 private:
  using Steps = std::array<std::int64_t, 2>;

  Steps rounded(const Point& point) const {
    return {std::llround(point.x * steps_per_module_), std::llround(point.y * steps_per_module_)};
  }

  void append(const Point& point) {
    const Steps to = rounded(point);
    data_ += decimal(static_cast<double>(to[0] - pen_[0]) / kStepsPerMillimetre, 6);
    data_ += ' ';
    data_ += decimal(static_cast<double>(to[1] - pen_[1]) / kStepsPerMillimetre, 6);
  }

  double steps_per_module_;
  Steps pen_{0, 0};
  std::string data_;
};

}  // namespace

std::string gear_path(const gearbox::ToothForm& form, double paper_mm_per_module) {
  std::vector<Cubic> pitch;
  for (const OutlineCurve& curve : gearbox::pitch_curves(form)) {
    if (curve.from != curve.to) append_cubics(curve, curve.from, curve.to, kMaxHalvings, pitch);
  }
  PathPen pen(paper_mm_per_module);
  pen.move(pitch.front()[0]);
  for (std::int64_t tooth = 0; tooth < form.teeth; ++tooth) {
    const double angle_rad =
        2.0 * std::numbers::pi * static_cast<double>(tooth) / static_cast<double>(form.teeth);
    for (const Cubic& cubic : pitch) {
      pen.curve(gearbox::turned(cubic[1], angle_rad), gearbox::turned(cubic[2], angle_rad),
                gearbox::turned(cubic[3], angle_rad));
    }
  }
  return pen.closed();
}

std::string circle_path(double radius_mm) {
  const std::string radius = decimal(radius_mm, 6);
  return fmt::format("M{0} 0A{0} {0} 0 1 1 -{0} 0A{0} {0} 0 1 1 {0} 0Z", radius);
}

}  // namespace torquewright::report
