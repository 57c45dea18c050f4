// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <stdexcept>

#include "tests/gearbox/proof/naive_proof.hpp"

namespace torquewright::gearbox::proof_test {
namespace {

/// Real teeth by gear name, from sun, planet_1, difference.
double teeth(const std::string& gear, const std::array<double, 3>& x) {
  if (gear == "sun") return x[0];
  if (gear == "planet_1" || gear == "planet") return x[1];
  if (gear == "planet_2") return x[1] - x[2];
  return x[0] + 2 * x[1] - (gear == "output_ring" ? x[2] : 0.0);
}

double ratio_form(bool upper, const Choice& c, const PlainBox& box,
                  const std::array<double, 3>& x) {
  const double t = number(c.problem->ratio_tolerance);
  const double g = number(c.problem->target_ratio) * (upper ? 1 + t : 1 - t);
  const double sign = upper ? 1 : -1;
  if (is_planetary(*c.problem)) return sign * (g * x[0] - 2 * x[0] - 2 * x[1]);
  const double curvature = 4 * (g - 1) / g;
  const double cone = g * x[0] + 2 * x[1];
  if (upper) return x[2] - 2 / g * x[1] - curvature * x[1] * x[1] / cone;
  const auto slope = [g](long sun, long first) {
    return static_cast<double>(first) /
           (g * static_cast<double>(sun) + 2.0 * static_cast<double>(first));
  };
  const double low = slope(box.upper[0], box.lower[1]), high = slope(box.lower[0], box.upper[1]);
  return 2 / g * x[1] + curvature * ((low + high) * x[1] - low * high * cone) - x[2];
}

double quantity_form(const PlainClaim& claim, const Choice& c, const PlainBox& box,
                     const std::array<double, 3>& x) {
  const Choice own = choice_of(*claim.reference, *claim.problem);
  const double threshold = quantity(claim.quantity, own, claim.reference->gears);
  const auto square = [](double v) { return v * v; };
  if (claim.quantity == "paper_cost") {
    const double bore = number(c.problem->rotor_inner_diameter_mm) / c.module_mm;
    return threshold - 1 / square(static_cast<double>(box.upper[0])) -
           square(x[0] + 2 * x[1] - bore) - square(x[1]) - square(x[1] - x[2]) -
           square(x[0] + 2 * x[1] - x[2]);
  }
  if (claim.quantity == "hollow_shaft") {
    const auto& stated = c.problem->hollow_shaft_wall_mm;
    const auto& ring = c.problem->ring_wall_mm;
    const double wall = stated ? number(*stated) : ring ? number(*ring) : 2.25 * c.module_mm;
    return c.module_mm *
               (x[0] - 2 * number(c.problem->cutters.hob_addendum.value_or(Rational(5, 4)))) -
           2 * wall - threshold;
  }
  if (claim.quantity.rfind("teeth.", 0) == 0) return teeth(claim.quantity.substr(6), x) - threshold;
  if (claim.quantity == "ring_pitch_diameter_mm") {
    return threshold - c.module_mm * teeth("fixed_ring", x);
  }
  throw std::invalid_argument(claim.quantity);
}

}  // namespace

double concave_form(const std::string& name, const PlainClaim& claim, const Choice& c,
                    const PlainBox& box, const std::array<double, 3>& x) {
  const Problem& p = *c.problem;
  const std::string part = name.substr(name.rfind('.') + 1);
  const std::string family = name.substr(0, name.find('.'));
  const double sine = std::sin(kPi / static_cast<double>(c.planet_count));
  if (name == "ratio_max" || name == "ratio_min") return ratio_form(name == "ratio_max", c, box, x);
  if (name == "quantity") return quantity_form(claim, c, box, x);
  if (name == "positive_teeth") return x[1] - x[2] - 1;
  if (name == "tooth_difference") return x[2] - static_cast<double>(c.planet_count);
  if (name == "rotor_bore") {
    const double bore = claim.ring_limit > 0 ? static_cast<double>(claim.ring_limit)
                                             : number(p.rotor_inner_diameter_mm) / c.module_mm;
    return bore - x[0] - 2 * x[1];
  }
  if (name == "carrier_clearance") {
    const double k =
        std::sin(kPi / static_cast<double>(c.planet_count) - number(p.min_carrier_clearance_rad));
    return k * x[0] - (1 - k) * x[1];
  }
  if (family == "min_teeth") return teeth(part, x) - static_cast<double>(p.min_teeth.at(part));
  if (family == "neighbour_clearance") {
    const double planet = part == "layer_1" ? x[1] : x[1] - x[2];
    return (x[0] + x[1]) * sine - (planet + 2) - number(p.min_neighbour_clearance_mm) / c.module_mm;
  }
  const double alpha = kPi / 9;
  if (family == "undercut") {
    const double hob = number(p.cutters.hob_tip_radius.value_or(Rational(19, 50)));
    const double straight =
        number(p.cutters.hob_addendum.value_or(Rational(5, 4))) - hob * (1 - std::sin(alpha));
    const double depth = p.cutters.hob_tip_radius ? straight : std::max(1.0, straight);
    return teeth(part, x) - 2 * depth / (std::sin(alpha) * std::sin(alpha));
  }
  if (family == "sun_under_layer_2") return c.module_mm * (x[2] / 2 - 2);
  if (family == "ring_tip") {
    return c.module_mm * (teeth(part, x) * (1 - std::cos(alpha)) - 2) / 2;
  }
  if (family == "shaper_feed") {
    const bool is_second = part == "planet_2_output_ring";
    const char* const ring = is_planetary(p) ? "ring" : is_second ? "output_ring" : "fixed_ring";
    return teeth(ring, x) - static_cast<double>(fewest_fed(p));
  }
  if (family == "ring_wall") {
    const double wall = p.ring_wall_mm ? number(*p.ring_wall_mm) : 2.25 * c.module_mm;
    return (number(p.ring_outer_diameter_mm.value_or(p.rotor_inner_diameter_mm)) -
            c.module_mm *
                (teeth(part, x) + 2 * number(p.cutters.shaper_addendum.value_or(Rational(5, 4))))) /
               2 -
           wall;
  }
  throw std::invalid_argument(name);
}

}  // namespace torquewright::gearbox::proof_test
