// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/gears/bodies.hpp"

#include <algorithm>
#include <string>

namespace torquewright::gearbox::proof {
namespace {

/// rho pi/4 b in kg per square millimetre of diameter squared.
Interval areal_mass(const Alternative& alternative, int layer) {
  const Problem& problem = *alternative.problem;
  const auto width = problem.face_width_mm.find("layer_" + std::to_string(layer));
  const Rational width_mm =
      width == problem.face_width_mm.end() ? Rational(0) : Rational(width->second);
  const Rational density = problem.density_kg_m3.value_or(Rational(0));
  return pi() * Interval(Rational(density * width_mm / 4 / 1'000'000'000));
}

Rational pitch_diameter_mm(const Alternative& alternative, std::int64_t teeth) {
  return alternative.module_mm * static_cast<long>(teeth);
}

/// Between two diameters: rho pi/4 b (D^2 - d^2) and m (D^2 + d^2)/8.
Body annulus(const Interval& areal_kg_mm2, const Rational& outer_mm, const Rational& inner_mm) {
  const Rational outer = outer_mm * outer_mm;
  const Rational inner = inner_mm * inner_mm;
  const Interval mass = areal_kg_mm2 * Interval(Rational(outer - inner));
  return {mass, mass * Interval(Rational((outer + inner) / 8 / 1'000'000))};
}

/// Root circle and wall beyond the pitch circle, both sides: 2 h m + 2 w.
Rational rim_mm(const Alternative& alternative, const Rational& root_depth) {
  return 2 * alternative.module_mm * root_depth + 2 * alternative.ring_wall_mm;
}

Interval mass_at(const Alternative& alternative, const Teeth& teeth) {
  Interval planets;
  Interval mass = sun_body(alternative, teeth.sun).mass_kg;
  for (int layer = 1; layer <= alternative.train->layers(); ++layer) {
    planets += planet_disc(alternative, planet(teeth, layer), layer).mass_kg;
    mass += ring_body(alternative, ring(teeth, layer), layer).mass_kg;
  }
  return mass + Interval(static_cast<long>(alternative.planet_count)) * planets;
}

/// n (m_P a^2/(1+I1)^2 + J_P ((1 - F/P1)/(1+I1))^2): the carrier carries the planets at m S/4 per
/// input, and they spin S/(2 P1) times as fast. A disc's inertia goes with P^4: that of layer 1,
/// spinning, grows with P1, that of layer 2 falls with it, so its spin takes a P1 of its own.
Interval planet_inertia(const Alternative& alternative, const Teeth& teeth,
                        std::int64_t planet_1_of_layer_2) {
  Interval result;
  const Rational arm_m = pitch_diameter_mm(alternative, teeth.sun) / 4 / 1000;
  for (int layer = 1; layer <= alternative.train->layers(); ++layer) {
    const Body disc = planet_disc(alternative, planet(teeth, layer), layer);
    const std::int64_t planet_1 = layer == 1 ? teeth.planet_1 : planet_1_of_layer_2;
    const Interval spin =
        Interval(static_cast<long>(teeth.sun)) / Interval(static_cast<long>(2 * planet_1));
    result += disc.mass_kg * Interval(Rational(arm_m * arm_m)) + disc.inertia_kg_m2 * square(spin);
  }
  return result * Interval(static_cast<long>(alternative.planet_count));
}

}  // namespace

Body sun_body(const Alternative& alternative, std::int64_t teeth) {
  const Rational pitch_mm = pitch_diameter_mm(alternative, teeth);
  const Rational depth = alternative.problem->cutters.hob_depth();
  const Rational bore_mm = std::max(Rational(0), Rational(pitch_mm - rim_mm(alternative, depth)));
  return annulus(areal_mass(alternative, 1), pitch_mm, bore_mm);
}

Body planet_disc(const Alternative& alternative, std::int64_t teeth, int layer) {
  return annulus(areal_mass(alternative, layer), pitch_diameter_mm(alternative, teeth), 0);
}

Body ring_body(const Alternative& alternative, std::int64_t teeth, int layer) {
  const Rational pitch_mm = pitch_diameter_mm(alternative, teeth);
  return annulus(areal_mass(alternative, layer),
                 pitch_mm + rim_mm(alternative, alternative.problem->cutters.shaper_depth()),
                 pitch_mm);
}

Interval total_mass_kg(const Alternative& alternative, const TeethRange& range) {
  return hull(mass_at(alternative, range.least), mass_at(alternative, range.most));
}

Interval reflected_inertia_kg_m2(const Alternative& alternative, const TeethRange& range,
                                 const Interval& ratio) {
  const auto& [least, most] = range;
  const Interval moving = hull(sun_body(alternative, least.sun).inertia_kg_m2 +
                                   planet_inertia(alternative, least, most.planet_1),
                               sun_body(alternative, most.sun).inertia_kg_m2 +
                                   planet_inertia(alternative, most, least.planet_1));
  const Interval input = Interval(alternative.problem->rotor_inertia_kg_m2) + moving;
  const Interval reflected = square(ratio) * input;
  if (!alternative.train->is_stepped()) return reflected;
  return reflected + hull(ring_body(alternative, ring(least, 2), 2).inertia_kg_m2,
                          ring_body(alternative, ring(most, 2), 2).inertia_kg_m2);
}

}  // namespace torquewright::gearbox::proof
