// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "gearbox/problem.hpp"
#include "gearbox/proof/gears/box.hpp"
#include "gearbox/proof/gears/interval.hpp"
#include "gearbox/proof/gears/train.hpp"

namespace torquewright::gearbox::proof {

/// Teeth beyond this are not judged: no gearbox has them, and the work stays bounded.
inline constexpr std::int64_t kMostTeeth = 1'000'000;

/// The problem with planet count and module chosen, and what follows from these.
struct Alternative {
  Alternative(const Problem& problem, std::int64_t planet_count, const Rational& module_mm);

  const Problem* problem;
  const Train* train;
  std::int64_t planet_count;
  Rational module_mm;
  Rational least_ratio, greatest_ratio;  ///< G(1-t), G(1+t), in ascending order.
  Rational largest_ring;                 ///< D/m, or the claim's ring limit; teeth.
  Rational ring_space_mm;  ///< What blanks have to fit into: stated, or the rotor's bore.
  Rational ring_wall_mm;
  Rational hollow_shaft_wall_mm;              ///< Stated, or a rim as thick as a ring's wall.
  std::array<Interval, 2> areal_mass_kg_mm2;  ///< rho pi/4 b of each layer: times diameter squared.
  Interval sine;                              ///< sin(pi/n)
  std::int64_t least_fed_ring;                ///< Where a shaper's teeth are stated, else 0.
};

/// Teeth of the free gears. In a train of one layer planet_2 is planet_1 once more, and plays no
/// part.
struct Teeth {
  std::int64_t sun = 0, planet_1 = 0, planet_2 = 0;
};

inline Teeth teeth_at(const Point& point) { return {point[0], point[1], point[1] - point[2]}; }

/// Teeth of the planet, and of the ring in mesh with it, in layer 1 or 2.
inline std::int64_t planet(const Teeth& teeth, int layer) {
  return layer == 1 ? teeth.planet_1 : teeth.planet_2;
}
inline std::int64_t ring(const Teeth& teeth, int layer) {
  return teeth.sun + teeth.planet_1 + planet(teeth, layer);
}

/// Least and most of each gear's teeth, the rings' too, among the designs in a box: planet_2 is at
/// least 1. Empty (least above most in planet_2) where the box holds no design.
struct TeethRange {
  Teeth least, most;
  bool is_empty() const { return least.planet_2 > most.planet_2; }
};
TeethRange teeth_in(const Box& box);

}  // namespace torquewright::gearbox::proof
