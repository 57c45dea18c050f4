// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/involute_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/oracles/reals.hpp"

namespace torquewright::oracles {
namespace {

// tan of the pressure angle at a circle whose base circle is cos_ratio times as wide.
long double tan_from_cos(long double cosine) { return std::sqrt(1 - cosine * cosine) / cosine; }

long double cos_at_tip(std::int64_t teeth) {
  return real(teeth) * std::cos(pressure_angle_rad()) / (real(teeth) + 2);
}

long double cos_at_ring_tip(std::int64_t ring) {
  return real(ring) * std::cos(pressure_angle_rad()) / (real(ring) - 2);
}

long double involute(long double angle_rad) { return std::tan(angle_rad) - angle_rad; }

// Base pitches between the pitch point and the point where an external gear's tip leaves the mesh.
long double reach_of_tip(std::int64_t teeth) {
  return real(teeth) * (tan_from_cos(cos_at_tip(teeth)) - std::tan(pressure_angle_rad())) /
         (2 * kPi);
}

// Antiderivative of 2|x|.
long double signed_square(long double x) { return x * std::fabs(x); }

long double pairs_in_contact(const ContactPath& path, long double x) {
  return std::floor(path.recess - x) + std::floor(path.approach + x) + 1;
}

}  // namespace

long double pressure_angle_rad() { return kPi / 9; }

ContactPath external_path(std::int64_t first, std::int64_t second) {
  return {reach_of_tip(second), reach_of_tip(first)};
}

ContactPath internal_path(std::int64_t planet, std::int64_t ring) {
  const long double at_ring_tip = tan_from_cos(cos_at_ring_tip(ring));
  return {real(ring) * (std::tan(pressure_angle_rad()) - at_ring_tip) / (2 * kPi),
          reach_of_tip(planet)};
}

long double involute_margin(std::int64_t planet, std::int64_t ring) {
  return real(planet) / real(ring) - 1 +
         tan_from_cos(cos_at_ring_tip(ring)) / std::tan(pressure_angle_rad());
}

long double trochoid_margin_rad(std::int64_t planet, std::int64_t ring) {
  // Lengths in modules; the two angles are those of the tip circles' intersection, seen from the
  // planet's and from the ring's centre.
  const long double planet_tip = real(planet) / 2 + 1;
  const long double ring_tip = real(ring) / 2 - 1;
  const long double distance = real(ring - planet) / 2;
  const long double at_reference = involute(pressure_angle_rad());
  const long double from_planet =
      std::acos((ring_tip * ring_tip - planet_tip * planet_tip - distance * distance) /
                (2 * distance * planet_tip)) +
      involute(std::acos(cos_at_tip(planet))) - at_reference;
  const long double from_ring =
      std::acos((distance * distance + ring_tip * ring_tip - planet_tip * planet_tip) /
                (2 * distance * ring_tip));
  return from_planet * real(planet) / real(ring) + at_reference -
         involute(std::acos(cos_at_ring_tip(ring))) - from_ring;
}

// Points of the line of action are counted from the pitch point, at s. An axis lies a pitch radius
// from there and the line rises by the pressure angle against the tangent, so that the squared
// distance to the axis is s^2 +- 2 s r sin(alpha) + r^2: + away from the axis.

long double straight_depth(long double hob_addendum, long double hob_tip_radius) {
  // The rounding touches flank and tip line: its lower 1 - sin(alpha) is all that is not straight.
  return hob_addendum - hob_tip_radius * (1 - std::sin(pressure_angle_rad()));
}

long double depth_at_ring_tip(std::int64_t ring) {
  const long double sine = std::sin(pressure_angle_rad());
  const long double pitch = real(ring) / 2;
  const long double tip = pitch - 1;
  if (tip <= pitch * std::cos(pressure_angle_rad())) return std::nanl("");
  // s^2 - 2 s r sin(alpha) + r^2 = tip^2, the nearer of the two points.
  const long double half = pitch * sine;
  const long double s = half - std::sqrt(half * half - (pitch * pitch - tip * tip));
  return s * sine;
}

long double depth_at_gear_tip(std::int64_t teeth) {
  return reach_of_planet(teeth) * std::sin(pressure_angle_rad());
}

long double reach_of_shaper(std::int64_t shaper, long double addendum, long double tip_radius) {
  // Where the rounding begins its centre lies on the line too, the tip radius nearer.
  const long double half = real(shaper) / 2 * std::sin(pressure_angle_rad());
  const long double centre = real(shaper) / 2 + addendum - tip_radius;
  const long double pitch = real(shaper) / 2;
  return std::sqrt(half * half - (pitch * pitch - centre * centre)) - half + tip_radius;
}

long double reach_of_planet(std::int64_t planet) {
  const long double half = real(planet) / 2 * std::sin(pressure_angle_rad());
  const long double pitch = real(planet) / 2;
  return std::sqrt(half * half + 2 * pitch + 1) - half;
}

long double height_over_fed_shaper(std::int64_t ring, std::int64_t shaper, long double addendum,
                                   long double tip_radius) {
  const long double quarter = std::numbers::pi_v<long double> / 2;
  const long double at_reference = involute(pressure_angle_rad());
  const long double cosine = std::cos(pressure_angle_rad());
  const long double tip = real(ring) / 2 - 1;
  const long double centre = real(shaper) / 2 + addendum - tip_radius;
  if (tip <= real(ring) / 2 * cosine || centre + tip_radius > tip) return std::nanl("");
  const long double base = real(shaper) / 2 * cosine;
  // Both from the middle of the space, which is the middle of the tooth, at no turn.
  const long double centre_rad = quarter / real(shaper) + at_reference -
                                 involute(std::acos(base / centre)) - tip_radius / base;
  const long double tip_rad =
      quarter / real(ring) + at_reference - involute(std::acos(cos_at_ring_tip(ring)));
  const auto height = [&](long double turn_rad) {
    return tip * std::sin(tip_rad + turn_rad * real(shaper) / real(ring)) -
           centre * std::sin(centre_rad + turn_rad) - tip_radius;
  };
  constexpr int kSteps = 400;
  const long double step = (quarter - centre_rad) / kSteps;
  int least = 0;
  for (int i = 1; i <= kSteps; ++i) {
    if (height(step * i) < height(step * least)) least = i;
  }
  // Between its neighbours the height has one least value; a third is cut off at a time.
  long double low = step * std::max(0, least - 1), high = step * std::min(kSteps, least + 1);
  for (int i = 0; i < 120; ++i) {
    const long double third = (high - low) / 3;
    (height(low + third) < height(high - third) ? high : low) +=
        height(low + third) < height(high - third) ? -third : third;
  }
  return height(low);
}

long double loss_factor(const ContactPath& path) {
  // The number of pairs changes only where one of them enters or leaves, whole base pitches from
  // either end; between those points the integral is closed form.
  std::vector<long double> ends{-path.approach, path.recess};
  for (long double offset = 1; offset < path.ratio(); ++offset) {
    ends.push_back(-path.approach + offset);
    ends.push_back(path.recess - offset);
  }
  std::sort(ends.begin(), ends.end());
  long double sum = 0;
  for (std::size_t piece = 1; piece < ends.size(); ++piece) {
    const long double middle = (ends[piece - 1] + ends[piece]) / 2;
    sum += (signed_square(ends[piece]) - signed_square(ends[piece - 1])) /
           pairs_in_contact(path, middle);
  }
  return sum;
}

long double external_efficiency(std::int64_t first, std::int64_t second, long double friction) {
  const long double curvature = 1 / real(first) + 1 / real(second);
  return 1 - friction * kPi * curvature * loss_factor(external_path(first, second));
}

long double internal_efficiency(std::int64_t planet, std::int64_t ring, long double friction) {
  const long double curvature = 1 / real(planet) - 1 / real(ring);
  return 1 - friction * kPi * curvature * loss_factor(internal_path(planet, ring));
}

}  // namespace torquewright::oracles
