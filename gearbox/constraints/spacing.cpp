// SPDX-License-Identifier: Apache-2.0
#include "gearbox/constraints/spacing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "gearbox/constraints/condition.hpp"
#include "gearbox/train/assembly.hpp"

namespace torquewright::gearbox {

namespace {

constexpr long double kPi = std::numbers::pi_v<long double>;

/// The clearance angle, in long double; exact where it is zero. It is so for six planets as large
/// as the sun only: asin of a fraction below 1 is a rational part of pi at 1/2 alone (Niven).
Rational clearance_rad(const PlanetCircle& circle) {
  if (circle.planet_count == 6 && circle.sun == circle.planet) return 0;
  const auto planet = static_cast<long double>(circle.planet);
  const auto sun = static_cast<long double>(circle.sun);
  const auto count = static_cast<long double>(circle.planet_count);
  return fraction_of(kPi / count - std::asin(planet / (sun + planet)));
}

/// sin(pi/n), exact where it is a fraction: 0, 1, 1/2 (Niven).
Rational sine_of_half_spacing(std::int64_t planet_count) {
  if (planet_count == 1) return 0;
  if (planet_count == 2) return 1;
  if (planet_count == 6) return Rational(1, 2);
  return fraction_of(std::sin(kPi / static_cast<long double>(planet_count)));
}

/// Largest number of planets below the present one that clears, 0 if none does.
std::int64_t clearing_count(PlanetCircle circle, const Rational& minimum_rad) {
  constexpr std::int64_t kMostPlanetsTried = 64;
  circle.planet_count = std::min(circle.planet_count - 1, kMostPlanetsTried);
  while (circle.planet_count > 0 && clearance_rad(circle) < minimum_rad) --circle.planet_count;
  return circle.planet_count;
}

/// Largest planet at this sun and count that clears, 0 if none does: P <= k S/(1 - k).
std::int64_t clearing_planet(PlanetCircle circle, const Rational& minimum_rad) {
  const double angle =
      std::numbers::pi / static_cast<double>(circle.planet_count) - io::nearest(minimum_rad);
  if (angle <= 0.0) return 0;
  const double share = std::sin(std::min(angle, std::numbers::pi / 2.0));
  const double largest = share * static_cast<double>(circle.sun) / (1.0 - share);
  if (!(largest < static_cast<double>(circle.planet))) return circle.planet - 1;
  circle.planet = static_cast<std::int64_t>(largest) + 1;
  while (circle.planet > 0 && clearance_rad(circle) < minimum_rad) --circle.planet;
  return circle.planet;
}

std::string clearance_remedy(const PlanetCircle& circle, const Rational& minimum_rad) {
  const std::int64_t count = clearing_count(circle, minimum_rad);
  const std::int64_t planet = clearing_planet(circle, minimum_rad);
  if (count > 0 && planet > 0) {
    return fmt::format("needs n <= {} or a planet of at most {} teeth at this sun", count, planet);
  }
  if (count > 0) return fmt::format("needs n <= {}", count);
  if (planet > 0) return fmt::format("needs a planet of at most {} teeth at this sun", planet);
  return "needs a smaller minimum: no planet clears it";
}

std::string dividing_counts(std::int64_t teeth) {
  std::string list;
  for (std::int64_t count = 2; count <= 8; ++count) {
    if (teeth % count == 0) list += (list.empty() ? "" : ", ") + std::to_string(count);
  }
  return list.empty() ? "none from 2 to 8" : list;
}

/// Least difference in clocking between two of the planet types.
double clocking_step_rad(const ThreeKTeeth<std::int64_t>& teeth, std::int64_t types) {
  const auto common = static_cast<double>(std::gcd(teeth.planet_1, teeth.planet_2));
  return 2.0 * std::numbers::pi * common /
         (static_cast<double>(teeth.planet_1) * static_cast<double>(teeth.planet_2) *
          static_cast<double>(types));
}

}  // namespace

ConstraintReport carrier_clearance(const PlanetCircle& circle, const Rational& minimum_rad) {
  DesignCondition condition{"carrier_clearance", "/min_carrier_clearance_rad", "rad"};
  condition.value = clearance_rad(circle);
  condition.limit = minimum_rad;
  condition.meaning =
      "from a planet's pitch circle to the middle between two planets, seen from the sun's axis";
  if (condition.value < condition.limit) {
    condition.remedy = clearance_remedy(circle, minimum_rad);
  }
  return judge(condition);
}

ConstraintReport equal_spacing(std::int64_t sun, std::int64_t ring, std::int64_t planet_count,
                               std::string_view ring_name) {
  DesignCondition condition{"equal_spacing", "", "teeth", Sense::kAtMost};
  condition.value = Rational(spacing_remainder(sun, ring, planet_count));
  condition.limit = 0;
  condition.meaning = fmt::format("left over when sun + {} = {} teeth are shared by {} planets",
                                  ring_name, sun + ring, planet_count);
  condition.remedy = fmt::format(
      "needs a number of planets that divides {} ({}), or planets spaced by whole multiples of "
      "{:.4g} rad",
      sun + ring, dividing_counts(sun + ring), spacing_unit_rad(sun, ring));
  return judge(condition);
}

ConstraintReport identical_planets(const ThreeKTeeth<std::int64_t>& teeth,
                                   std::int64_t planet_count) {
  const std::int64_t types = planet_type_count(teeth, planet_count);
  DesignCondition condition{"identical_planets", "", "1", Sense::kAtMost};
  condition.value = Rational(types);
  condition.limit = 1;
  condition.meaning = types == 1 ? "planet part number: all planets are alike"
                                 : "different planets would be needed";
  condition.remedy = fmt::format(
      "needs {} planet part numbers that differ in the angle between planet 1's and planet 2's "
      "teeth "
      "by steps of {:.4g} rad, or other teeth or planets",
      types, clocking_step_rad(teeth, types));
  return judge(condition);
}

ConstraintReport neighbour_clearance(const PlanetCircle& circle, std::string_view layer,
                                     std::int64_t planet_in_layer, const Rational& minimum_mm) {
  DesignCondition condition{fmt::format("neighbour_clearance.{}", layer),
                            "/min_neighbour_clearance_mm", "mm", Sense::kMoreThan};
  const Rational chord =
      Rational(circle.sun + circle.planet) * sine_of_half_spacing(circle.planet_count);
  condition.value = circle.module_mm * (chord - planet_in_layer - 2);
  condition.limit = minimum_mm;
  condition.meaning = "between the tips of neighbouring planets";
  const double largest = io::nearest(Rational(chord - minimum_mm / circle.module_mm)) - 2.0;
  condition.remedy =
      largest >= 1.0
          ? fmt::format("needs fewer planets or, at this centre distance, fewer than {:.4g} teeth",
                        largest)
          : "needs fewer planets or a longer centre distance";
  return judge(condition);
}

}  // namespace torquewright::gearbox
