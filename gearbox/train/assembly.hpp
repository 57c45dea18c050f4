// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "gearbox/train/kinematics.hpp"

namespace torquewright::gearbox {

// Whether the teeth meet when n planets stand at equal angles. docs/derivations/kinematics.md.
// Counts are exact for any teeth: products are formed in whole numbers of any size.

/// (S + F) mod n; 0: the sun and the held ring mesh with n equally spaced planets.
std::int64_t spacing_remainder(std::int64_t sun, std::int64_t held_ring, std::int64_t planet_count);

/// n g divides O P1 - F P2, g = gcd(P1, P2): all planets are alike. Eq. (10).
bool has_identical_planets(const ThreeKTeeth<std::int64_t>& teeth, std::int64_t planet_count);

/// Number of different stepped planets, n/gcd(n, |O P1 - F P2|/g). Eq. (11).
std::int64_t planet_type_count(const ThreeKTeeth<std::int64_t>& teeth, std::int64_t planet_count);

/// Angle of planet 2's teeth against planet 1's on the planet at position i, relative to position
/// 0, in [0, 2 pi g/(P1 P2)) [rad]. Eq. (12).
double planet_clocking_rad(const ThreeKTeeth<std::int64_t>& teeth, std::int64_t planet_count,
                           std::int64_t position);

/// Planets can stand at whole multiples of this angle, equally spaced or not [rad].
double spacing_unit_rad(std::int64_t sun, std::int64_t held_ring);

/// How the planets' mesh forces follow each other at the held ring.
enum class Phasing {
  kInPhase,     ///< All at once: torque ripples, no sideways force.
  kSequential,  ///< One after the other around the ring.
  kCounter,     ///< Neither.
};
Phasing phasing(std::int64_t held_ring, std::int64_t planet_count);

/// Every tooth meets every tooth: the counts have no common divisor.
bool is_hunting(std::int64_t teeth_1, std::int64_t teeth_2);

}  // namespace torquewright::gearbox
