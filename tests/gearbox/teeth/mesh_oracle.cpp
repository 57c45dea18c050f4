// SPDX-License-Identifier: Apache-2.0
#include "tests/gearbox/teeth/mesh_oracle.hpp"

#include <cmath>
#include <numbers>

#include "gearbox/teeth/root_fillet.hpp"

namespace torquewright::gearbox {
namespace {

constexpr double kChordError = 1e-7;
constexpr double kToothReach = 3.0;  // Farther from its tooth's middle no point lies.

// A gear's half pitch as points, and what the membership test needs.
struct Solid {
  PlacedGear gear;
  std::vector<Point> half;
  double flank_low = 0.0;  // Radii between which the flank is an involute.
  double flank_high = 0.0;
};

Solid solid_of(const PlacedGear& gear) {
  Solid solid{.gear = gear, .half = sample(half_pitch_curves(gear.form), kChordError)};
  if (gear.form.internal) {
    solid.flank_low = std::max(gear.form.tip_radius, base_radius(gear.form));
    const auto shaped = shaper_trochoid(gear.form);
    solid.flank_high = shaped ? trochoid_point(*shaped, shaped->end_turn_rad).radius
                              : ring_fillet(gear.form).flank_end.radius;
  } else {
    const HobTrochoid trochoid = hob_trochoid(gear.form);
    solid.flank_low = trochoid_point(trochoid, trochoid.end_normal_rad).radius;
    solid.flank_high = gear.form.tip_radius;
  }
  return solid;
}

// Distance along the string from the involute that leaves the base circle at the tooth's edge.
double involute_depth(const ToothForm& form, double radius, double angle_rad) {
  const double pressure_rad = 20.0 * std::numbers::pi / 180.0;
  const double teeth = static_cast<double>(form.teeth);
  const double base = 0.5 * teeth * std::cos(pressure_rad);
  const double string = std::sqrt(std::max(0.0, radius * radius - base * base));
  const double unwound_rad = string / base;
  const double edge_rad =
      (0.5 * std::numbers::pi + 2.0 * form.profile_shift * std::tan(pressure_rad)) / teeth +
      std::tan(pressure_rad) - pressure_rad;
  return base * (edge_rad - angle_rad - unwound_rad + std::atan2(string, base));
}

// Signed distance from the chord of the half pitch at this radius, positive towards the x axis.
double chord_depth(const std::vector<Point>& half, double radius, const Point& point) {
  const auto below = [](double value, const Point& corner) {
    return value > std::hypot(corner.x, corner.y);
  };
  auto end = std::upper_bound(half.begin(), half.end(), radius, below);
  if (end == half.begin()) ++end;
  if (end == half.end()) --end;
  const Point& from = *(end - 1);
  const Point& to = *end;
  const double x = to.x - from.x;
  const double y = to.y - from.y;
  return (x * (point.y - from.y) - y * (point.x - from.x)) / std::hypot(x, y);
}

void measure_point(const Solid& solid, const Point& point, Contact& contact) {
  const ToothForm& form = solid.gear.form;
  const Point offset{point.x - solid.gear.center.x, point.y - solid.gear.center.y};
  const double radius = std::hypot(offset.x, offset.y);
  const double inside_tip = form.internal ? radius - form.tip_radius : form.tip_radius - radius;
  if (inside_tip <= 0.0) return;
  const double pitch_rad = 2.0 * std::numbers::pi / static_cast<double>(form.teeth);
  const double from_middle_rad =
      std::remainder(std::atan2(offset.y, offset.x) - solid.gear.phase_rad, pitch_rad);
  const double angle_rad = std::abs(from_middle_rad);
  const bool on_flank = radius >= solid.flank_low && radius <= solid.flank_high;
  const Point folded{radius * std::cos(angle_rad), radius * std::sin(angle_rad)};
  double depth =
      on_flank ? involute_depth(form, radius, angle_rad) : chord_depth(solid.half, radius, folded);
  if (form.internal) depth = -depth;
  double& side = from_middle_rad < 0.0 ? contact.right : contact.left;
  side = std::max(side, std::min(depth, inside_tip));
}

// Whether a tooth whose middle is at `middle` can reach the other gear's teeth.
bool can_reach(const PlacedGear& other, const Point& middle) {
  const double distance = std::hypot(middle.x - other.center.x, middle.y - other.center.y);
  return other.form.internal ? distance > other.form.tip_radius - kToothReach
                             : distance < other.form.tip_radius + kToothReach;
}

void measure_points_of(const PlacedGear& gear, const Solid& other, Contact& contact) {
  const std::vector<Point> pitch = sample(pitch_curves(gear.form), kChordError);
  const double teeth = static_cast<double>(gear.form.teeth);
  for (std::int64_t tooth = 0; tooth < gear.form.teeth; ++tooth) {
    const double angle_rad =
        gear.phase_rad + 2.0 * std::numbers::pi * static_cast<double>(tooth) / teeth;
    const auto placed = [&](const Point& point) {
      const Point direction = turned(point, angle_rad);
      return Point{gear.center.x + direction.x, gear.center.y + direction.y};
    };
    if (!can_reach(other.gear, placed({0.5 * teeth, 0.0}))) continue;
    for (const Point& point : pitch) measure_point(other, placed(point), contact);
  }
}

}  // namespace

Contact measure_contact(const PlacedGear& first, const PlacedGear& second) {
  Contact of_first;
  Contact of_second;
  measure_points_of(first, solid_of(second), of_second);
  measure_points_of(second, solid_of(first), of_first);
  // The counter-clockwise flank of a tooth meets the counter-clockwise flank of the mate's tooth,
  // and that side of a ring's space; each side's deepest point may be found from either gear.
  return {std::max(of_first.left, of_second.left), std::max(of_first.right, of_second.right)};
}

Contact measure_points(const std::vector<Point>& points, const PlacedGear& gear) {
  const Solid solid = solid_of(gear);
  Contact contact;
  for (const Point& point : points) measure_point(solid, point, contact);
  return contact;
}

}  // namespace torquewright::gearbox
