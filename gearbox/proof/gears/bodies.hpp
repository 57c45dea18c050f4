// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/proof/gears/alternative.hpp"
#include "gearbox/proof/gears/rough_interval.hpp"

namespace torquewright::gearbox::proof {

/// Mass in kg and inertia about the own axis in kg m^2.
template <typename Number>
struct Body {
  Number mass_kg, inertia_kg_m2;
};

/// Discs and annuli of docs/gearbox_constraints.md, of one alternative. `Number` here and below is
/// Interval or RoughInterval.
template <typename Number>
class Bodies {
 public:
  explicit Bodies(const Alternative& alternative)
      : alternative_(alternative),
        module_mm_(alternative.module_mm),
        sun_rim_mm_(rim_mm(alternative.problem->cutters.hob_depth())),
        ring_rim_mm_(rim_mm(alternative.problem->cutters.shaper_depth())) {}

  Body<Number> sun(std::int64_t teeth) const {
    const Number pitch_mm = pitch_diameter_mm(teeth);
    return annulus(1, pitch_mm, max(pitch_mm - sun_rim_mm_, 0));
  }
  Body<Number> planet_disc(std::int64_t teeth, int layer) const {
    return annulus(layer, pitch_diameter_mm(teeth), 0);
  }
  Body<Number> ring_body(std::int64_t teeth, int layer) const {
    const Number pitch_mm = pitch_diameter_mm(teeth);
    return annulus(layer, pitch_mm + ring_rim_mm_, pitch_mm);
  }

  Number mass_at(const Teeth& teeth) const {
    Number planets = 0;
    Number mass = sun(teeth.sun).mass_kg;
    for (int layer = 1; layer <= alternative_.train->layers(); ++layer) {
      planets = planets + planet_disc(planet(teeth, layer), layer).mass_kg;
      mass = mass + ring_body(ring(teeth, layer), layer).mass_kg;
    }
    return mass + number<Number>(alternative_.planet_count) * planets;
  }

  /// n (m_P a^2/(1+I1)^2 + J_P ((1 - F/P1)/(1+I1))^2): the carrier carries the planets at m S/4 per
  /// input, and they spin S/(2 P1) times as fast. A disc's inertia goes with P^4: that of layer 1,
  /// spinning, grows with P1, that of layer 2 falls with it, so its spin takes a P1 of its own.
  Number planet_inertia(const Teeth& teeth, std::int64_t planet_1_of_layer_2) const {
    Number result = 0;
    const Number arm_m = pitch_diameter_mm(teeth.sun) / 4000;
    for (int layer = 1; layer <= alternative_.train->layers(); ++layer) {
      const Body<Number> disc = planet_disc(planet(teeth, layer), layer);
      const std::int64_t planet_1 = layer == 1 ? teeth.planet_1 : planet_1_of_layer_2;
      const Number spin = number<Number>(teeth.sun) / number<Number>(2 * planet_1);
      result = result + disc.mass_kg * square(arm_m) + disc.inertia_kg_m2 * square(spin);
    }
    return result * number<Number>(alternative_.planet_count);
  }

 private:
  /// Root circle and wall beyond the pitch circle, both sides: 2 h m + 2 w.
  Rational rim_mm(const Rational& root_depth) const {
    return 2 * alternative_.module_mm * root_depth + 2 * alternative_.ring_wall_mm;
  }

  Number pitch_diameter_mm(std::int64_t teeth) const { return module_mm_ * number<Number>(teeth); }

  /// Between two diameters: rho pi/4 b (D^2 - d^2) and m (D^2 + d^2)/8.
  Body<Number> annulus(int layer, const Number& outer_mm, const Number& inner_mm) const {
    const Number outer = square(outer_mm);
    const Number inner = square(inner_mm);
    const Number areal_kg_mm2 = alternative_.areal_mass_kg_mm2[static_cast<std::size_t>(layer - 1)];
    const Number mass = areal_kg_mm2 * (outer - inner);
    return {mass, mass * (outer + inner) / 8'000'000};
  }

  const Alternative& alternative_;
  Number module_mm_, sun_rim_mm_, ring_rim_mm_;
};

/// An interval that holds the mass of every design in the range. It is tight, for each body's mass
/// grows with its teeth.
template <typename Number>
Number total_mass_kg(const Alternative& alternative, const TeethRange& range);

/// An interval that holds the inertia at the output of every design in the range whose ratio lies
/// in `ratio`.
template <typename Number>
Number reflected_inertia_kg_m2(const Alternative& alternative, const TeethRange& range,
                               const Number& ratio);

}  // namespace torquewright::gearbox::proof
