// SPDX-License-Identifier: Apache-2.0
#include "gearbox/teeth/tooth_outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearbox/teeth/root_fillet.hpp"

namespace torquewright::gearbox {
namespace {

constexpr int kFirstPieces = 4;  // So that no symmetric curve hides from the midpoint test.
constexpr int kMaxHalvings = 16;

Point cartesian(double radius, double angle_rad) {
  return {radius * std::cos(angle_rad), radius * std::sin(angle_rad)};
}

OutlineCurve circle_arc(double radius, double from_rad, double to_rad) {
  return {[radius](double angle_rad) { return cartesian(radius, angle_rad); }, from_rad, to_rad};
}

// Eq. (1), by the tangent of the profile angle, in which the involute is smooth down to its cusp.
OutlineCurve involute_flank(const ToothForm& form, double from_radius, double to_radius) {
  const double base = base_radius(form);
  const double half_rad = base_half_angle_rad(form);
  const auto tangent = [base](double radius) {
    return std::sqrt(std::max(0.0, (radius / base) * (radius / base) - 1.0));
  };
  return {[base, half_rad](double t) {
            return cartesian(base * std::sqrt(1.0 + t * t), half_rad - (t - std::atan(t)));
          },
          tangent(from_radius), tangent(to_radius), true};
}

std::vector<OutlineCurve> external_half_pitch(const ToothForm& form) {
  const HobTrochoid trochoid = hob_trochoid(form);
  const double flank_start = trochoid_point(trochoid, trochoid.end_normal_rad).radius;
  const double root_start_rad = trochoid_point(trochoid, 0.5 * std::numbers::pi).angle_rad;
  const auto fillet = [trochoid](double normal_rad) {
    const PolarPoint point = trochoid_point(trochoid, normal_rad);
    return cartesian(point.radius, point.angle_rad);
  };
  return {circle_arc(form.tip_radius, 0.0, half_angle_rad(form, form.tip_radius)),
          involute_flank(form, form.tip_radius, flank_start),
          {fillet, trochoid.end_normal_rad, 0.5 * std::numbers::pi},
          circle_arc(form.root_radius, root_start_rad, trochoid.half_pitch_rad)};
}

OutlineCurve ring_fillet_arc(const RingFillet& fillet) {
  const Point center = cartesian(fillet.center.radius, fillet.center.angle_rad);
  const Point end = cartesian(fillet.flank_end.radius, fillet.flank_end.angle_rad);
  const auto arc = [center, radius = fillet.radius](double angle_rad) {
    const Point offset = cartesian(radius, angle_rad);
    return Point{center.x + offset.x, center.y + offset.y};
  };
  return {arc, fillet.center.angle_rad, std::atan2(end.y - center.y, end.x - center.x)};
}

/// Root circle and fillet of a ring, and the radius at which its involute begins.
struct RingRoot {
  std::vector<OutlineCurve> curves;
  double flank_radius = 0.0;
};

RingRoot ring_root(const ToothForm& form) {
  if (const auto trochoid = shaper_trochoid(form)) {
    const auto fillet = [trochoid](double turn_rad) {
      const PolarPoint point = trochoid_point(*trochoid, turn_rad);
      return cartesian(point.radius, point.angle_rad);
    };
    const double land_rad = trochoid_point(*trochoid, 0.0).angle_rad;
    return {{circle_arc(form.root_radius, 0.0, land_rad), {fillet, 0.0, trochoid->end_turn_rad}},
            trochoid_point(*trochoid, trochoid->end_turn_rad).radius};
  }
  const RingFillet fillet = ring_fillet(form);
  return {{circle_arc(form.root_radius, 0.0, fillet.center.angle_rad), ring_fillet_arc(fillet)},
          fillet.flank_end.radius};
}

std::vector<OutlineCurve> internal_half_pitch(const ToothForm& form) {
  const RingRoot root = ring_root(form);
  const double half_pitch_rad = std::numbers::pi / static_cast<double>(form.teeth);
  const double flank_end = std::max(form.tip_radius, base_radius(form));
  const double tip_angle_rad = std::min(half_angle_rad(form, flank_end), half_pitch_rad);
  std::vector<OutlineCurve> curves = root.curves;
  curves.push_back(involute_flank(form, root.flank_radius, flank_end));
  if (form.tip_radius < flank_end) {  // No involute inside the base circle: straight to the tip.
    curves.push_back({[tip_angle_rad](double radius) { return cartesian(radius, tip_angle_rad); },
                      flank_end, form.tip_radius});
  }
  curves.push_back(circle_arc(form.tip_radius, tip_angle_rad, half_pitch_rad));
  return curves;
}

double distance_to_chord(const Point& point, const Point& from, const Point& to) {
  const double x = to.x - from.x;
  const double y = to.y - from.y;
  const double length = std::hypot(x, y);
  if (length == 0.0) return std::hypot(point.x - from.x, point.y - from.y);
  return std::abs(x * (point.y - from.y) - y * (point.x - from.x)) / length;
}

// Appends the points after `from` up to `to`.
void sample_piece(const OutlineCurve& curve, double from, double to, double chord_error,
                  int halvings, std::vector<Point>& points) {
  const double middle = 0.5 * (from + to);
  const Point end = curve.point(to);
  const double error = distance_to_chord(curve.point(middle), curve.point(from), end);
  if (error <= chord_error || halvings == 0) {
    points.push_back(end);
    return;
  }
  sample_piece(curve, from, middle, chord_error, halvings - 1, points);
  sample_piece(curve, middle, to, chord_error, halvings - 1, points);
}

}  // namespace

Point turned(const Point& point, double angle_rad) {
  const double cosine = std::cos(angle_rad);
  const double sine = std::sin(angle_rad);
  return {cosine * point.x - sine * point.y, sine * point.x + cosine * point.y};
}

std::vector<OutlineCurve> half_pitch_curves(const ToothForm& form) {
  return form.internal ? internal_half_pitch(form) : external_half_pitch(form);
}

std::vector<OutlineCurve> pitch_curves(const ToothForm& form) {
  const std::vector<OutlineCurve> half = half_pitch_curves(form);
  std::vector<OutlineCurve> curves;
  for (auto curve = half.rbegin(); curve != half.rend(); ++curve) {
    const auto mirrored = [point = curve->point](double t) {
      const Point original = point(t);
      return Point{original.x, -original.y};
    };
    curves.push_back({mirrored, curve->to, curve->from, curve->is_flank});
  }
  curves.insert(curves.end(), half.begin(), half.end());
  return curves;
}

std::vector<Point> sample(const std::vector<OutlineCurve>& curves, double chord_error) {
  std::vector<Point> points;
  if (!curves.empty()) points.push_back(curves.front().point(curves.front().from));
  for (const OutlineCurve& curve : curves) {
    if (curve.from == curve.to) continue;
    const double step = (curve.to - curve.from) / kFirstPieces;
    for (int piece = 0; piece < kFirstPieces; ++piece) {
      const double end = piece + 1 == kFirstPieces ? curve.to : curve.from + (piece + 1) * step;
      sample_piece(curve, curve.from + piece * step, end, chord_error, kMaxHalvings, points);
    }
  }
  return points;
}

}  // namespace torquewright::gearbox
