// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numbers>

#include "tests/oracles/gearbox_objectives.hpp"
#include "tests/oracles/reals.hpp"
#include "tests/oracles/rule_families.hpp"

namespace torquewright::oracles {
namespace {

struct Body {
  long double mass_kg = 0;
  long double inertia_kg_m2 = 0;  ///< About its own axis.
};

// What the bodies are cut from: lengths in metres.
struct Stock {
  long double density_kg_m3;
  long double module_m;
  long double ring_thickness_m;  ///< k = 2 h m + 2 w, on the diameter.
  long double sun_thickness_m;
  long double width_1_m;
  long double width_2_m;
};

Stock stock(const Setting& setting) {
  const gearbox::Problem& problem = setting.problem;
  const Rational& module = setting.module_mm;
  const Rational wall = problem.ring_wall_mm.value_or(Rational(9, 4) * module);
  const auto thickness = [&](const std::optional<Rational>& depth) {
    return to_long_double(2 * depth.value_or(Rational(5, 4)) * module + 2 * wall) / 1000;
  };
  const auto metres = [](const Rational& millimetres) {
    return to_long_double(millimetres) / 1000;
  };
  const Rational second = is_3k(problem) ? problem.face_width_mm.at("layer_2") : Rational(0);
  return {to_long_double(problem.density_kg_m3.value()), metres(module),
          thickness(problem.cutters.shaper_addendum),    thickness(problem.cutters.hob_addendum),
          metres(problem.face_width_mm.at("layer_1")),   metres(second)};
}

// A disc is an annulus without a hole.
Body annulus(const Stock& of, long double width_m, long double outer_m, long double inner_m) {
  const long double outer = outer_m * outer_m;
  const long double inner = inner_m * inner_m;
  const long double mass_kg =
      of.density_kg_m3 * std::numbers::pi_v<long double> / 4 * width_m * (outer - inner);
  return {mass_kg, mass_kg * (outer + inner) / 8};
}

Body ring(const Stock& of, long double width_m, std::int64_t teeth) {
  const long double pitch_m = of.module_m * real(teeth);
  return annulus(of, width_m, pitch_m + of.ring_thickness_m, pitch_m);
}

Body sun(const Stock& of, const Teeth& teeth) {
  const long double pitch_m = of.module_m * real(teeth.sun);
  return annulus(of, of.width_1_m, pitch_m, std::max(0.0L, pitch_m - of.sun_thickness_m));
}

Body planet(const Stock& of, const Teeth& teeth) {
  const Body first = annulus(of, of.width_1_m, of.module_m * real(teeth.planet_1), 0);
  const Body second = annulus(of, of.width_2_m, of.module_m * real(teeth.planet_2), 0);
  return {first.mass_kg + second.mass_kg, first.inertia_kg_m2 + second.inertia_kg_m2};
}

}  // namespace

long double mass_kg(const Setting& setting, const Teeth& teeth) {
  const Stock of = stock(setting);
  const long double output_ring_kg =
      is_3k(setting.problem) ? ring(of, of.width_2_m, teeth.output_ring).mass_kg : 0;
  return real(setting.planet_count) * planet(of, teeth).mass_kg +
         ring(of, of.width_1_m, teeth.fixed_ring).mass_kg + output_ring_kg + sun(of, teeth).mass_kg;
}

long double reflected_inertia_kg_m2(const Setting& setting, const Teeth& teeth) {
  const Stock of = stock(setting);
  const bool three_k = is_3k(setting.problem);
  const auto [p, q] = three_k ? ratio_3k(teeth) : ratio_planetary(teeth);
  const long double ratio = static_cast<long double>(p) / static_cast<long double>(q);
  // Speeds over the sun's speed. The carrier of a single stage turns with the output.
  const long double carrier = real(teeth.sun) / real(teeth.sun + teeth.fixed_ring);
  const long double spin = carrier * (1 - real(teeth.fixed_ring) / real(teeth.planet_1));
  const long double distance_m = of.module_m * real(teeth.sun + teeth.planet_1) / 2;
  const Body wheel = planet(of, teeth);
  const long double orbiting = wheel.mass_kg * distance_m * distance_m * carrier * carrier;
  const long double at_sun =
      to_long_double(setting.problem.rotor_inertia_kg_m2) + sun(of, teeth).inertia_kg_m2 +
      real(setting.planet_count) * (orbiting + wheel.inertia_kg_m2 * spin * spin);
  const long double at_output =
      three_k ? ring(of, of.width_2_m, teeth.output_ring).inertia_kg_m2 : 0;
  return ratio * ratio * at_sun + at_output;
}

}  // namespace torquewright::oracles
