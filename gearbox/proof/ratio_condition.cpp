// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/ratio_condition.hpp"

#include <algorithm>

namespace torquewright::gearbox::proof {
namespace {

mpz_class whole(std::int64_t value) { return mpz_class(static_cast<long>(value)); }

/// h S (P1 - P2) - 2 P1 (S + P1 + P2): for h > 0 it has the sign of (P1 - P2) - phi_h, that is of
/// h - i where P1 > P2.
Rational excess(const Rational& h, std::int64_t sun, std::int64_t first, std::int64_t second) {
  const mpz_class lever = whole(sun) * whole(first - second);
  const mpz_class path = 2 * whole(first) * whole(sun + first + second);
  return h * lever - path;
}

/// Greatest excess over P1 in [fewest, most]: a parabola open below, -2 P1^2 + P1 (h S - 2 S - 2
/// P2).
Rational greatest_excess(const Rational& h, std::int64_t sun, std::int64_t fewest,
                         std::int64_t most, std::int64_t second) {
  const Rational vertex = (h * whole(sun) - whole(2 * sun + 2 * second)) / 4;
  const mpz_class below =
      vertex.get_num() >= 0 ? mpz_class(vertex.get_num() / vertex.get_den()) : mpz_class(0);
  const std::int64_t near =
      below > whole(most) ? most : std::clamp<std::int64_t>(below.get_si(), fewest, most);
  const std::int64_t next = std::min(near + 1, most);
  return std::max(excess(h, sun, near, second), excess(h, sun, next, second));
}

/// i <= h exactly where this is not negative.
Rational planetary_excess(const Rational& h, std::int64_t sun, std::int64_t planet_teeth) {
  return h * whole(sun) - whole(2 * sun + 2 * planet_teeth);
}

Rational greatest_planetary_excess(const Rational& h, const Box& box) {
  return std::max(planetary_excess(h, box.lower[0], box.lower[1]),
                  planetary_excess(h, box.upper[0], box.lower[1]));
}

Rational least_planetary_excess(const Rational& h, const Box& box) {
  return std::min(planetary_excess(h, box.lower[0], box.upper[1]),
                  planetary_excess(h, box.upper[0], box.upper[1]));
}

}  // namespace

Rational ratio_of(const Alternative& alternative, const Point& point) {
  const auto& [sun, first, second] = point;
  Rational ratio = alternative.planetary ? Rational(whole(2 * (sun + first)), whole(sun))
                                         : Rational(2 * whole(first) * whole(sun + first + second),
                                                    whole(sun) * whole(first - second));
  ratio.canonicalize();
  return ratio;
}

bool has_ratio_in(const RatioRange& range, const Alternative& alternative, const Point& point) {
  if (!alternative.planetary && point[1] == point[2]) return false;
  const Rational ratio = ratio_of(alternative, point);
  return range.least <= ratio && ratio <= range.greatest;
}

bool exceeds_everywhere(const Rational& h, const Alternative& alternative, const Box& box) {
  if (alternative.planetary) return greatest_planetary_excess(h, box) < 0;
  // phi_h falls in S for h > 1 and grows for h < 1: the sun that comes nearest to h.
  const std::int64_t sun = h >= 1 ? box.upper[0] : box.lower[0];
  return greatest_excess(h, sun, box.lower[1], box.upper[1], box.lower[2]) < 0;
}

bool falls_short_everywhere(const Rational& h, const Alternative& alternative, const Box& box) {
  if (alternative.planetary) return least_planetary_excess(h, box) > 0;
  // Open below, so the least excess stands at an end of P1.
  const std::int64_t sun = h >= 1 ? box.lower[0] : box.upper[0];
  return excess(h, sun, box.lower[1], box.upper[2]) > 0 &&
         excess(h, sun, box.upper[1], box.upper[2]) > 0;
}

bool all_above(const RatioRange& range, const Alternative& alternative, const Box& box) {
  const Rational& h = range.greatest;
  if (alternative.planetary || range.least > 0) return exceeds_everywhere(h, alternative, box);
  const std::int64_t difference = box.lower[2] - box.upper[1];
  if (h >= 0 || difference <= 0) return false;
  return -h * whole(box.lower[0]) * whole(difference) >
         2 * whole(box.upper[1]) * whole(box.upper[0] + box.upper[1] + box.upper[2]);
}

bool all_below(const RatioRange& range, const Alternative& alternative, const Box& box) {
  const Rational& h = range.least;
  if (alternative.planetary || h > 0) return falls_short_everywhere(h, alternative, box);
  if (range.greatest >= 0) return false;
  const std::int64_t difference = box.upper[2] - box.lower[1];
  if (difference <= 0) return true;
  return -h * whole(box.upper[0]) * whole(difference) <
         2 * whole(box.lower[1]) * whole(box.lower[0] + box.lower[1] + box.lower[2]);
}

}  // namespace torquewright::gearbox::proof
