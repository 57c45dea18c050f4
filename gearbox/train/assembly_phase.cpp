// SPDX-License-Identifier: Apache-2.0
#include "gearbox/train/assembly_phase.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace torquewright::gearbox {
namespace {

// Tooth counts and planets stay below this, so that no product of three overflows.
constexpr std::int64_t kMaxCount = 1'000'000;

void require_count(std::int64_t count) {
  if (count < 1 || count > kMaxCount) {
    throw std::invalid_argument("assembly phase: a count outside [1, 1000000]");
  }
}

// numerator / denominator of a full turn, reduced to [0, 1) before it is rounded.
double turns_rad(std::int64_t numerator, std::int64_t denominator) {
  std::int64_t remainder = numerator % denominator;
  if (remainder < 0) remainder += denominator;
  return 2.0 * std::numbers::pi * static_cast<double>(remainder) / static_cast<double>(denominator);
}

std::int64_t modulo(std::int64_t value, std::int64_t modulus) {
  return (value % modulus + modulus) % modulus;
}

// The x in [0, modulus) with factor x = 1 mod modulus; the two have no common divisor.
std::int64_t inverse(std::int64_t factor, std::int64_t modulus) {
  std::int64_t previous = modulus, current = modulo(factor, modulus);
  std::int64_t previous_x = 0, current_x = 1;
  while (current != 0) {
    const std::int64_t quotient = previous / current;
    previous = std::exchange(current, previous - quotient * current);
    previous_x = std::exchange(current_x, previous_x - quotient * current_x);
  }
  return modulo(previous_x, modulus);
}

// Eq. (6): the place j of planet i, of N = S + F places, nearest to equal spacing.
std::int64_t place_of(std::int64_t planet, std::int64_t planet_count, std::int64_t places) {
  return (2 * planet * places + planet_count) / (2 * planet_count);
}

AssemblyPhase place_layer_1(std::int64_t sun, std::int64_t planet, std::int64_t ring,
                            std::int64_t planet_count) {
  for (const std::int64_t count : {sun, planet, ring, planet_count}) require_count(count);
  const std::int64_t places = sun + ring;
  AssemblyPhase phase;
  phase.sun_rad = planet % 2 == 0 ? std::numbers::pi / static_cast<double>(sun) : 0.0;  // Eq. (4).
  phase.equally_spaced = places % planet_count == 0;
  for (std::int64_t i = 0; i < planet_count; ++i) {
    const std::int64_t place = place_of(i, planet_count, places);
    PlanetPhase& position = phase.planets.emplace_back();
    position.position_rad = turns_rad(place, places);
    // Eq. (7) with k = 0.
    position.planet_1_rad = turns_rad(place * (planet - ring), places * planet);
  }
  return phase;
}

void number_parts(AssemblyPhase& phase, const std::vector<std::int64_t>& remainders) {
  std::vector<std::int64_t> types;
  for (std::size_t i = 0; i < remainders.size(); ++i) {
    auto type = std::find(types.begin(), types.end(), remainders[i]);
    if (type == types.end()) type = types.insert(types.end(), remainders[i]);
    phase.planets[i].part_number = type - types.begin() + 1;
  }
  phase.planet_types = static_cast<std::int64_t>(types.size());
}

}  // namespace

AssemblyPhase assemble_3k(const CompoundTeeth& teeth, std::int64_t planet_count) {
  AssemblyPhase phase = place_layer_1(teeth.sun, teeth.planet_1, teeth.fixed_ring, planet_count);
  for (const std::int64_t count : {teeth.planet_2, teeth.output_ring}) require_count(count);
  const std::int64_t places = teeth.sun + teeth.fixed_ring;
  const std::int64_t g = std::gcd(teeth.planet_1, teeth.planet_2);
  const std::int64_t p1 = teeth.planet_1 / g;
  const std::int64_t p2 = teeth.planet_2 / g;
  const std::int64_t q = teeth.output_ring * p1 - teeth.fixed_ring * p2;  // Eq. (9).
  std::vector<std::int64_t> remainders;
  for (std::int64_t i = 0; i < planet_count; ++i) {
    const std::int64_t place = place_of(i, planet_count, places);
    // Eq. (10): q place = places * (l p1 - k p2) + remainder.
    const std::int64_t remainder = modulo(q * place, places);
    const std::int64_t steps = (q * place - remainder) / places;
    // Eq. (11): k = -steps / p2 modulo p1, the turn of planet 1 that makes room for clocking.
    const std::int64_t k = p1 == 1 ? 0 : modulo(-steps * inverse(p2, p1), p1);
    PlanetPhase& planet = phase.planets[static_cast<std::size_t>(i)];
    planet.planet_1_rad = turns_rad(place * (teeth.planet_1 - teeth.fixed_ring) + k * places,
                                    places * teeth.planet_1);
    planet.clocking_rad = -turns_rad(1, places * p1 * p2 * g) * static_cast<double>(remainder);
    planet.planet_2_rad = planet.planet_1_rad + planet.clocking_rad;
    remainders.push_back(remainder);
  }
  number_parts(phase, remainders);
  return phase;
}

AssemblyPhase assemble_compound(std::int64_t sun, std::int64_t planet_1, std::int64_t planet_2,
                                std::int64_t ring, std::int64_t planet_count) {
  for (const std::int64_t count : {sun, planet_1, planet_2, ring, planet_count}) {
    require_count(count);
  }
  AssemblyPhase phase;
  phase.sun_rad =
      planet_1 % 2 == 0 ? std::numbers::pi / static_cast<double>(sun) : 0.0;  // Eq. (4).
  const std::int64_t g = std::gcd(planet_1, planet_2);
  const std::int64_t p1 = planet_1 / g, p2 = planet_2 / g;
  const std::int64_t q = ring * p1 + sun * p2;  // Eq. (13).
  std::vector<std::int64_t> remainders;
  for (std::int64_t i = 0; i < planet_count; ++i) {
    const std::int64_t remainder = modulo(q * i, planet_count);
    const std::int64_t steps = (q * i - remainder) / planet_count;
    const std::int64_t k = p1 == 1 ? 0 : modulo(-modulo(steps, p1) * inverse(p2, p1), p1);
    PlanetPhase& planet = phase.planets.emplace_back();
    planet.position_rad = turns_rad(i, planet_count);
    // Eq. (14), with k for room as in eq. (11).
    planet.planet_1_rad =
        turns_rad(i * (planet_1 + sun) + k * planet_count, planet_count * planet_1);
    planet.clocking_rad =
        -turns_rad(1, planet_count * p1 * p2 * g) * static_cast<double>(remainder);
    planet.planet_2_rad = planet.planet_1_rad + planet.clocking_rad;
    remainders.push_back(remainder);
  }
  number_parts(phase, remainders);
  return phase;
}

AssemblyPhase assemble_planetary(std::int64_t sun, std::int64_t planet, std::int64_t ring,
                                 std::int64_t planet_count) {
  return place_layer_1(sun, planet, ring, planet_count);
}

}  // namespace torquewright::gearbox
