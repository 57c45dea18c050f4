// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/root_form.hpp"

#include "gearbox/proof/tooth_path.hpp"

namespace torquewright::gearbox::proof {
namespace {

Rational dedendum() { return Rational(5, 4); }

/// From the base tangent point to a circle of this radius, in modules.
Interval string_to(const Rational& radius, std::int64_t teeth) {
  const Interval base = number(teeth) * cos(pressure_angle()) / 2;
  return sqrt(square(Interval(radius)) - square(base));
}

Interval string_to_pitch_point(std::int64_t teeth) {
  return number(teeth) * sin(pressure_angle()) / 2;
}

}  // namespace

Interval straight_depth(const Problem& problem) {
  if (!problem.cutters.hob_tip_radius) return 1;
  return Interval(dedendum()) -
         Interval(*problem.cutters.hob_tip_radius) * (1 - sin(pressure_angle()));
}

bool is_not_undercut(const Problem& problem, std::int64_t teeth) {
  return sign(number(teeth) * square(sin(pressure_angle())) - 2 * straight_depth(problem)) >= 0;
}

bool has_root_form_of_hob(const Problem& problem, std::int64_t ring) {
  if (!has_tip_outside_base(ring)) return false;
  // The ring's tip lies this far before the pitch point; the hob goes sin(alpha) as deep there.
  const Rational tip = whole(ring) / 2 - 1;
  const Interval before = string_to_pitch_point(ring) - string_to(tip, ring);
  return sign(straight_depth(problem) - sin(pressure_angle()) * before) >= 0;
}

bool has_root_form_of_shaper(const Problem& problem, std::int64_t planet, std::int64_t ring) {
  const std::int64_t shaper = *problem.cutters.shaper_teeth;
  if (ring <= shaper) return false;
  const Rational rounding = problem.cutters.shaper_tip_radius.value_or(Rational(0));
  const Rational centre = whole(shaper) / 2 + dedendum() - rounding;
  const Rational tip = whole(planet) / 2 + 1;
  const Interval left =
      string_to(centre, shaper) + Interval(rounding) - string_to_pitch_point(shaper);
  const Interval needed = string_to(tip, planet) - string_to_pitch_point(planet);
  return sign(left - needed) >= 0;
}

}  // namespace torquewright::gearbox::proof
