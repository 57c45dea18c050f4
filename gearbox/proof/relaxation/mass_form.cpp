// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/gears/bodies.hpp"
#include "gearbox/proof/relaxation/concave_forms.hpp"

namespace torquewright::gearbox::proof {
namespace {

/// The sun is an annulus for every sun of the box: m S_l >= k. Then its mass is linear in S.
bool is_annulus(const Alternative& alternative, std::int64_t least_sun) {
  const Rational pitch_mm = alternative.module_mm * static_cast<long>(least_sun);
  const Rational depth = alternative.problem->cutters.hob_depth();
  return pitch_mm >= Rational(2 * alternative.module_mm * depth + 2 * alternative.ring_wall_mm);
}

/// A function that is linear in z, from two of its values.
struct Line {
  Interval constant, slope;
};

template <typename Mass>
Line line_through(Mass mass, std::int64_t z) {
  const Interval slope = mass(z + 1) - mass(z);
  return {mass(z) - slope * Interval(static_cast<long>(z)), slope};
}

Line sun_line(const Alternative& alternative, const Bodies<Interval>& bodies,
              std::int64_t least_sun) {
  const auto mass = [&](std::int64_t z) { return bodies.sun(z).mass_kg; };
  if (is_annulus(alternative, least_sun)) return line_through(mass, least_sun);
  return {mass(least_sun), 0};
}

}  // namespace

Linearization mass_form(const Alternative& alternative, const Interval& threshold, const Box& box,
                        const RealPoint& point) {
  const Bodies<Interval> bodies(alternative);
  const Line sun = sun_line(alternative, bodies, box.lower[0]);
  Linearization result = affine(point, threshold - sun.constant, {-sun.slope, 0, 0});
  const Interval count(static_cast<long>(alternative.planet_count));
  for (int layer = 1; layer <= alternative.train->layers(); ++layer) {
    const auto mass = [&](std::int64_t z) { return bodies.ring_body(z, layer).mass_kg; };
    const Line rings = line_through(mass, 0);
    result += ring_form(-rings.slope, -rings.constant, layer, point);
    const Interval discs = count * bodies.planet_disc(1, layer).mass_kg;
    result += negative_square(point, discs, 0, {0, 1, layer == 1 ? 0 : -1});
  }
  return result;
}

}  // namespace torquewright::gearbox::proof
