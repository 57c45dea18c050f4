// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/gears/root_form.hpp"

#include "gearbox/proof/gears/tooth_path.hpp"

namespace torquewright::gearbox::proof {
namespace {

/// From the base tangent point to a circle of this radius, in modules.
Interval string_to(const Rational& radius, std::int64_t teeth) {
  const Interval base = number(teeth) * cos(pressure_angle()) / 2;
  return sqrt(square(Interval(radius)) - square(base));
}

Interval string_to_pitch_point(std::int64_t teeth) {
  return number(teeth) * sin(pressure_angle()) / 2;
}

Interval straight_depth(const Problem& problem, const Rational& tip_radius) {
  return Interval(problem.cutters.hob_depth()) - Interval(tip_radius) * (1 - sin(pressure_angle()));
}

}  // namespace

Interval undercut_depth(const Problem& problem) {
  const auto& cutters = problem.cutters;
  if (cutters.hob_tip_radius) return straight_depth(problem, *cutters.hob_tip_radius);
  return max(Interval(1), straight_depth(problem, Rational(38, 100)));
}

bool is_not_undercut(const Problem& problem, std::int64_t teeth) {
  return sign(number(teeth) * square(sin(pressure_angle())) - 2 * undercut_depth(problem)) >= 0;
}

bool has_root_form_of_hob(const Problem& problem, std::int64_t ring) {
  if (!has_tip_outside_base(ring)) return false;
  // The ring's tip lies this far before the pitch point; the hob goes sin(alpha) as deep there.
  const Rational tip = whole(ring) / 2 - 1;
  const Interval before = string_to_pitch_point(ring) - string_to(tip, ring);
  const Rational rounding = problem.cutters.hob_tip_radius.value_or(Rational(0));
  return sign(straight_depth(problem, rounding) - sin(pressure_angle()) * before) >= 0;
}

bool has_root_form_of_hob(const Problem& problem, std::int64_t sun, std::int64_t planet) {
  const Interval depth = straight_depth(problem, *problem.cutters.hob_tip_radius);
  for (const std::int64_t mate : {sun, planet}) {
    const Rational tip = whole(mate) / 2 + 1;
    const Interval before = string_to(tip, mate) - string_to_pitch_point(mate);
    if (sign(depth - sin(pressure_angle()) * before) < 0) return false;
  }
  return true;
}

bool has_root_form_of_shaper(const Problem& problem, std::int64_t planet, std::int64_t ring) {
  const std::int64_t shaper = problem.cutters.shaper_teeth.value_or(planet);
  if (ring <= shaper) return false;
  const Rational rounding = problem.cutters.shaper_tip_radius.value_or(Rational(0));
  const Rational centre = whole(shaper) / 2 + problem.cutters.shaper_depth() - rounding;
  const Rational tip = whole(planet) / 2 + 1;
  const Interval left =
      string_to(centre, shaper) + Interval(rounding) - string_to_pitch_point(shaper);
  const Interval needed = string_to(tip, planet) - string_to_pitch_point(planet);
  return sign(left - needed) >= 0;
}

}  // namespace torquewright::gearbox::proof
