// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/gears/bodies.hpp"

namespace torquewright::gearbox::proof {

template <typename Number>
Number total_mass_kg(const Alternative& alternative, const TeethRange& range) {
  const Bodies<Number> bodies(alternative);
  return hull(bodies.mass_at(range.least), bodies.mass_at(range.most));
}

template <typename Number>
Number reflected_inertia_kg_m2(const Alternative& alternative, const TeethRange& range,
                               const Number& ratio) {
  const auto& [least, most] = range;
  const Bodies<Number> bodies(alternative);
  const Number moving =
      hull(bodies.sun(least.sun).inertia_kg_m2 + bodies.planet_inertia(least, most.planet_1),
           bodies.sun(most.sun).inertia_kg_m2 + bodies.planet_inertia(most, least.planet_1));
  const Number input = Number(alternative.problem->rotor_inertia_kg_m2) + moving;
  const Number reflected = square(ratio) * input;
  if (!alternative.train->is_stepped()) return reflected;
  return reflected + hull(bodies.ring_body(ring(least, 2), 2).inertia_kg_m2,
                          bodies.ring_body(ring(most, 2), 2).inertia_kg_m2);
}

template Interval total_mass_kg(const Alternative&, const TeethRange&);
template RoughInterval total_mass_kg(const Alternative&, const TeethRange&);
template Interval reflected_inertia_kg_m2(const Alternative&, const TeethRange&, const Interval&);
template RoughInterval reflected_inertia_kg_m2(const Alternative&, const TeethRange&,
                                               const RoughInterval&);

}  // namespace torquewright::gearbox::proof
