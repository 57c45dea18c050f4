// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/gears/interference.hpp"

#include "gearbox/proof/gears/tooth_path.hpp"

namespace torquewright::gearbox::proof {
namespace {

Rational half(std::int64_t teeth) {
  Rational value(static_cast<long>(teeth), 2L);
  value.canonicalize();
  return value;
}

}  // namespace

bool is_free_of_involute_interference(std::int64_t planet, std::int64_t ring) {
  const Interval tooth_ratio = Interval(half(planet) / half(ring));
  return sign(tooth_ratio - 1 + tan(ring_tip_angle(ring)) / tan(pressure_angle())) >= 0;
}

bool is_free_of_trochoid_interference(std::int64_t planet, std::int64_t ring) {
  // In modules. The cosines are fractions, so that those at the ends, +-1, are met exactly.
  const Rational planet_tip = half(planet) + 1;
  const Rational ring_tip = half(ring) - 1;
  const Rational centre = half(ring) - half(planet);
  const Rational squares = ring_tip * ring_tip - planet_tip * planet_tip;
  const Rational cosine_1 = (squares - centre * centre) / (2 * centre * planet_tip);
  const Rational cosine_2 = (squares + centre * centre) / (2 * centre * ring_tip);

  const Interval theta_1 =
      acos(Interval(cosine_1)) + involute(external_tip_angle(planet)) - involute(pressure_angle());
  const Interval theta_2 = acos(Interval(cosine_2));
  const Interval margin = theta_1 * Interval(half(planet) / half(ring)) +
                          involute(pressure_angle()) - involute(ring_tip_angle(ring)) - theta_2;
  return margin.is_defined() && sign(margin) >= 0;
}

}  // namespace torquewright::gearbox::proof
