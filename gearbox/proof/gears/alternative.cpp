// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/gears/alternative.hpp"

#include <algorithm>
#include <string>

#include "gearbox/proof/gears/shaper_feed.hpp"

namespace torquewright::gearbox::proof {
namespace {

Interval areal_mass_kg_mm2(const Problem& problem, int layer) {
  const auto width = problem.face_width_mm.find("layer_" + std::to_string(layer));
  const Rational width_mm =
      width == problem.face_width_mm.end() ? Rational(0) : Rational(width->second);
  const Rational density = problem.density_kg_m3.value_or(Rational(0));
  return pi() * Interval(Rational(density * width_mm / 4 / 1'000'000'000));
}

}  // namespace

Alternative::Alternative(const Problem& the_problem, std::int64_t count, const Rational& module)
    : problem(&the_problem),
      train(&train_of(the_problem)),
      planet_count(count),
      module_mm(module),
      least_ratio(the_problem.target_ratio * (1 - the_problem.ratio_tolerance)),
      greatest_ratio(the_problem.target_ratio * (1 + the_problem.ratio_tolerance)),
      largest_ring(the_problem.rotor_inner_diameter_mm / module),
      ring_space_mm(
          the_problem.ring_outer_diameter_mm.value_or(the_problem.rotor_inner_diameter_mm)),
      ring_wall_mm(the_problem.ring_wall_mm.value_or(Rational(module * Rational(9, 4)))),
      hollow_shaft_wall_mm(the_problem.hollow_shaft_wall_mm.value_or(ring_wall_mm)),
      areal_mass_kg_mm2{proof::areal_mass_kg_mm2(the_problem, 1),
                        proof::areal_mass_kg_mm2(the_problem, 2)},
      sine(sin(pi() / Interval(static_cast<long>(count)))),
      least_fed_ring(the_problem.cutters.shaper_teeth ? proof::least_fed_ring(the_problem) : 0) {
  // A reversed output has a negative target, for which the factors change places.
  if (least_ratio > greatest_ratio) std::swap(least_ratio, greatest_ratio);
}

TeethRange teeth_in(const Box& box) {
  const std::int64_t fewest = std::max<std::int64_t>(1, box.lower[1] - box.upper[2]);
  return {{box.lower[0], box.lower[1], fewest},
          {box.upper[0], box.upper[1], box.upper[1] - box.lower[2]}};
}

}  // namespace torquewright::gearbox::proof
