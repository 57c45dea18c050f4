// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/gears/shaper_feed.hpp"

#include "gearbox/proof/gears/interval.hpp"

namespace torquewright::gearbox::proof {
namespace {

Interval rack_angle() { return pi() / 9; }

Interval involute_of(const Interval& angle) { return tan(angle) - angle; }

/// Half the angle of a tooth at a radius, without profile shift.
Interval half_angle(std::int64_t teeth, const Rational& radius) {
  const Interval base = number(teeth) * cos(rack_angle()) / 2;
  return pi() / (2 * number(teeth)) + involute_of(rack_angle()) -
         involute_of(acos(base / Interval(radius)));
}

/// Whether a ring of so many teeth keeps its tips when the shaper is fed in. At the turn where the
/// shaper's rounding, with its centre at the radius c, passes the ring's tip closest, the heights
/// of both agree, s + rho = t sin(theta_2), s = c sin(theta_1), and so do their speeds, c
/// cos(theta_1) = k t cos(theta_2), k the shaper's teeth over the ring's: two equations for s.
bool is_fed(const Problem& problem, std::int64_t ring) {
  const std::int64_t shaper = *problem.cutters.shaper_teeth;
  const Rational rounding = problem.cutters.shaper_tip_radius.value_or(Rational(0));
  const Rational centre = whole(shaper) / 2 + problem.cutters.shaper_depth() - rounding;
  const Rational tip = whole(ring) / 2 - 1;
  if (centre + rounding > tip) return false;
  // The ring's tips lie outside its base circle.
  if (sign(Interval(tip) - number(ring) * cos(rack_angle()) / 2) <= 0) return false;
  const Rational k = whole(shaper) / whole(ring);
  const Rational square_k = k * k;
  const Rational root =
      square_k * square_k * rounding * rounding +
      (1 - square_k) * (centre * centre + square_k * rounding * rounding - square_k * tip * tip);
  if (root < 0) return false;
  const Interval height =
      (Interval(Rational(square_k * rounding)) + sqrt(Interval(root))) / Interval(1 - square_k);
  const Interval sine_1 = height / Interval(centre);
  const Interval sine_2 = (height + Interval(rounding)) / Interval(tip);
  if (sign(1 - sine_1) < 0 || sign(1 - sine_2) < 0) return false;
  const Interval base = number(shaper) * cos(rack_angle()) / 2;
  const Interval turn = asin(sine_1) - (half_angle(shaper, centre) - Interval(rounding) / base);
  return sign(Interval(k) * turn + half_angle(ring, tip) - asin(sine_2)) >= 0;
}

}  // namespace

std::int64_t least_fed_ring(const Problem& problem) {
  const std::int64_t shaper = *problem.cutters.shaper_teeth;
  std::int64_t ring = shaper + 1;
  const std::int64_t most = 2 * shaper + 100;
  while (ring < most && !is_fed(problem, ring)) ++ring;
  return ring;
}

}  // namespace torquewright::gearbox::proof
