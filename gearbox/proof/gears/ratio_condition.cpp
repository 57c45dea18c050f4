// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/gears/ratio_condition.hpp"

namespace torquewright::gearbox::proof {
namespace {

mpz_class integer(std::int64_t value) { return mpz_class(static_cast<long>(value)); }

/// h S d - 2 P1 (S + 2 P1 - d), which has the sign of h - i; planetary h S - 2 S - 2 P.
Rational excess(const Rational& h, const Alternative& alternative, std::int64_t sun,
                std::int64_t first, std::int64_t difference) {
  if (!alternative.train->is_stepped()) return h * integer(sun) - integer(2 * (sun + first));
  const mpz_class lever = integer(sun) * integer(difference);
  return h * lever - 2 * integer(first) * integer(sun + 2 * first - difference);
}

/// The end of the sun's range at which the excess is greatest. For h > 0 its sign is that of
/// d - phi_h, and phi_h = 2 P1 (S + 2 P1)/(h S + 2 P1) falls in S for h > 1, grows for h < 1. Where
/// h <= 0 it is negative at any end. Planetary: the slope in S is h - 2.
std::int64_t sun_of_greatest_excess(const Rational& h, const Alternative& alternative,
                                    const Box& box) {
  return h >= (alternative.train->is_stepped() ? 1 : 2) ? box.upper[0] : box.lower[0];
}

std::int64_t sun_of_least_excess(const Rational& h, const Alternative& alternative,
                                 const Box& box) {
  return h >= (alternative.train->is_stepped() ? 1 : 2) ? box.lower[0] : box.upper[0];
}

}  // namespace

Rational ratio_of(const Alternative& alternative, const Teeth& teeth) {
  Rational ratio = alternative.train->is_stepped()
                       ? Rational(2 * integer(teeth.planet_1) * integer(ring(teeth, 2)),
                                  integer(teeth.sun) * integer(teeth.planet_1 - teeth.planet_2))
                       : Rational(2 * integer(teeth.sun + teeth.planet_1), integer(teeth.sun));
  ratio.canonicalize();
  return ratio;
}

bool has_ratio_in(const RatioRange& range, const Alternative& alternative, const Teeth& teeth) {
  const Rational ratio = ratio_of(alternative, teeth);
  return range.least <= ratio && ratio <= range.greatest;
}

bool exceeds_everywhere(const Rational& limit, const Alternative& alternative, const Box& box) {
  const std::int64_t sun = sun_of_greatest_excess(limit, alternative, box);
  return excess(limit, alternative, sun, box.lower[1], box.upper[2]) < 0;
}

bool falls_short_everywhere(const Rational& limit, const Alternative& alternative, const Box& box) {
  const std::int64_t sun = sun_of_least_excess(limit, alternative, box);
  return excess(limit, alternative, sun, box.upper[1], box.lower[2]) > 0;
}

}  // namespace torquewright::gearbox::proof
