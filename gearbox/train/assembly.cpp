// SPDX-License-Identifier: Apache-2.0
#include "gearbox/train/assembly.hpp"

#include <gmpxx.h>

#include <numbers>
#include <numeric>

namespace torquewright::gearbox {

namespace {

mpz_class whole(std::int64_t value) { return mpz_class(static_cast<long>(value)); }

/// value mod divisor in [0, divisor).
mpz_class remainder_of(const mpz_class& value, const mpz_class& divisor) {
  mpz_class result;
  mpz_fdiv_r(result.get_mpz_t(), value.get_mpz_t(), divisor.get_mpz_t());
  return result;
}

/// Q = (O P1 - F P2)/gcd(P1, P2), eq. (9). gcd divides it because it divides both products.
mpz_class phase_number(const ThreeKTeeth<std::int64_t>& teeth) {
  return (whole(teeth.output_ring) * whole(teeth.planet_1) -
          whole(teeth.fixed_ring) * whole(teeth.planet_2)) /
         whole(std::gcd(teeth.planet_1, teeth.planet_2));
}

}  // namespace

std::int64_t spacing_remainder(std::int64_t sun, std::int64_t held_ring,
                               std::int64_t planet_count) {
  return remainder_of(whole(sun) + whole(held_ring), whole(planet_count)).get_si();
}

bool has_identical_planets(const ThreeKTeeth<std::int64_t>& teeth, std::int64_t planet_count) {
  return planet_type_count(teeth, planet_count) == 1;
}

std::int64_t planet_type_count(const ThreeKTeeth<std::int64_t>& teeth, std::int64_t planet_count) {
  const mpz_class count = whole(planet_count);
  return mpz_class(count / gcd(count, phase_number(teeth))).get_si();
}

double planet_clocking_rad(const ThreeKTeeth<std::int64_t>& teeth, std::int64_t planet_count,
                           std::int64_t position) {
  const mpz_class step = remainder_of(-whole(position) * phase_number(teeth), whole(planet_count));
  const double turns = step.get_d() / static_cast<double>(planet_count);
  const auto common = static_cast<double>(std::gcd(teeth.planet_1, teeth.planet_2));
  return turns * 2.0 * std::numbers::pi * common /
         (static_cast<double>(teeth.planet_1) * static_cast<double>(teeth.planet_2));
}

double spacing_unit_rad(std::int64_t sun, std::int64_t held_ring) {
  return 2.0 * std::numbers::pi / (static_cast<double>(sun) + static_cast<double>(held_ring));
}

Phasing phasing(std::int64_t held_ring, std::int64_t planet_count) {
  const std::int64_t rest = held_ring % planet_count;
  if (rest == 0) return Phasing::kInPhase;
  if (rest == 1 || rest == planet_count - 1) return Phasing::kSequential;
  return Phasing::kCounter;
}

bool is_hunting(std::int64_t teeth_1, std::int64_t teeth_2) {
  return std::gcd(teeth_1, teeth_2) == 1;
}

}  // namespace torquewright::gearbox
