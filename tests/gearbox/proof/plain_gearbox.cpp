// SPDX-License-Identifier: Apache-2.0
#include "tests/gearbox/proof/plain_gearbox.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>

namespace torquewright::gearbox::proof_test {
namespace {

constexpr double kAlpha = kPi / 9;
constexpr double kSlack = 1e-9;

double real(long value) { return static_cast<double>(value); }
long ring_1(const Gears& g) { return g.sun + 2 * g.first; }
long ring_2(const Gears& g) { return g.sun + g.first + g.second; }

std::string last_part(const std::string& name) { return name.substr(name.rfind('.') + 1); }
bool starts_with(const std::string& name, const std::string& prefix) {
  return name.rfind(prefix, 0) == 0;
}

long gear(const std::string& name, const Gears& g) {
  if (name == "sun") return g.sun;
  if (name == "planet_2") return g.second;
  if (name == "planet_1" || name == "planet") return g.first;
  return name == "output_ring" ? ring_2(g) : ring_1(g);
}

double path_external(long z) {
  const double angle = std::acos(real(z) * std::cos(kAlpha) / real(z + 2));
  return real(z) * (std::tan(angle) - std::tan(kAlpha)) / (2 * kPi);
}

double ring_angle(long z) {
  const double cosine = real(z) * std::cos(kAlpha) / real(z - 2);
  return cosine >= 1 || z <= 2 ? 0.0 : std::acos(cosine);
}

double path_ring(long z) {
  return real(z) * (std::tan(kAlpha) - std::tan(ring_angle(z))) / (2 * kPi);
}

double hob_addendum(const Problem& p) {
  return number(p.cutters.hob_addendum.value_or(Rational(5, 4)));
}
double shaper_addendum(const Problem& p) {
  return number(p.cutters.shaper_addendum.value_or(Rational(5, 4)));
}

/// To which the hob is straight: its rounding hides 1 - sin of its radius.
double hob_depth(const Problem& p) {
  return hob_addendum(p) - number(p.cutters.hob_tip_radius.value_or(0)) * (1 - std::sin(kAlpha));
}

double undercut_depth(const Problem& p) {
  if (p.cutters.hob_tip_radius) return hob_depth(p);
  return std::max(1.0, hob_addendum(p) - .38 * (1 - std::sin(kAlpha)));
}

/// Beyond the pitch point: where the shaper's involute goes over into its rounding, in modules.
double shaper_path(const Problem& p, long planet) {
  const double r = real(p.cutters.shaper_teeth.value_or(planet)) / 2;
  const double rounding = number(p.cutters.shaper_tip_radius.value_or(0));
  const double at_centre = std::acos(r * std::cos(kAlpha) / (r + shaper_addendum(p) - rounding));
  return r * std::cos(kAlpha) * (std::tan(at_centre) - std::tan(kAlpha)) + rounding;
}

double involute(double angle) { return std::tan(angle) - angle; }

/// The fewest teeth of a ring whose tip stays above the rounding of the shaper's tip at every turn,
/// which is tried in steps; below it every ring loses its tips.
long simulated_fewest_fed(const Problem& p) {
  const long q = *p.cutters.shaper_teeth;
  const double rounding = number(p.cutters.shaper_tip_radius.value_or(0));
  const double centre = real(q) / 2 + shaper_addendum(p) - rounding;
  const double base = real(q) / 2 * std::cos(kAlpha);
  const double middle =
      kPi / 2 / real(q) + involute(kAlpha) - involute(std::acos(base / centre)) - rounding / base;
  for (long z = std::max(q + 1, 34L);; ++z) {
    const double tip = real(z) / 2 - 1;
    const double corner = kPi / 2 / real(z) + involute(kAlpha) - involute(ring_angle(z));
    double least = tip - centre - rounding;
    for (double turn = 0; turn + middle < kPi / 2; turn += 1e-4) {
      least = std::min(least, tip * std::sin(corner + turn * real(q) / real(z)) -
                                  centre * std::sin(middle + turn) - rounding);
    }
    if (least >= 0) return z;
  }
}

double wall_mm(const Choice& c) {
  return c.problem->ring_wall_mm ? number(*c.problem->ring_wall_mm) : 2.25 * c.module_mm;
}

double sun_wall_mm(const Choice& c) {
  const auto& stated = c.problem->hollow_shaft_wall_mm;
  return stated ? number(*stated) : wall_mm(c);
}

double neighbour_mm(const Choice& c, const Gears& g, long planet) {
  return c.module_mm *
         (real(g.sun + g.first) * std::sin(kPi / real(c.planet_count)) - real(planet + 2));
}

double trochoid(long planet, long ring) {
  const double p = real(planet), r = real(ring);
  const double tip_1 = p / 2 + 1, tip_2 = r / 2 - 1, a = (r - p) / 2;
  const double own = std::acos(p * std::cos(kAlpha) / (p + 2));
  const double theta_1 = std::acos((tip_2 * tip_2 - tip_1 * tip_1 - a * a) / (2 * a * tip_1)) +
                         involute(own) - involute(kAlpha);
  const double theta_2 = std::acos((a * a + tip_2 * tip_2 - tip_1 * tip_1) / (2 * a * tip_2));
  return theta_1 * p / r + involute(kAlpha) - involute(ring_angle(ring)) - theta_2;
}

/// 2 int |x|/k(x) dx piece by piece: between the points where a pair enters or leaves, and zero,
/// the integrand is linear. k counts the pairs x + j within the path.
double loss_integral(double approach, double recess) {
  std::vector<double> ends{-approach, 0.0, recess};
  for (int j = 1; j < approach + recess; ++j) {
    ends.push_back(j - approach);
    ends.push_back(recess - j);
  }
  std::sort(ends.begin(), ends.end());
  double sum = 0;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double middle = (ends[i - 1] + ends[i]) / 2;
    const double pairs = std::floor(middle + approach) + std::floor(recess - middle) + 1;
    sum += std::abs(middle) / pairs * (ends[i] - ends[i - 1]);
  }
  return 2 * sum;
}

double mesh_efficiency(const Choice& c, const Gears& g, int mesh) {
  const long z1 = mesh == 0 ? g.sun : mesh == 1 ? g.first : g.second;
  const long z2 = mesh == 0 ? g.first : mesh == 1 ? ring_1(g) : ring_2(g);
  const double mate = mesh == 0 ? path_external(z2) : path_ring(z2);
  const double curvature = mesh == 0 ? 1 / real(z1) + 1 / real(z2) : 1 / real(z1) - 1 / real(z2);
  return 1 - number(*c.problem->friction_coefficient) * kPi * curvature *
                 loss_integral(path_external(z1), mate);
}

/// Power passes a mesh whose ring has its tip outside its base circle, where a pair is always in
/// contact, and where friction leaves something.
bool passes(const Choice& c, const Gears& g, int mesh) {
  const long ring = mesh == 1 ? ring_1(g) : ring_2(g);
  const bool has_involute = mesh == 0 || real(ring) / 2 - 1 > real(ring) / 2 * std::cos(kAlpha);
  return has_involute && contact_ratio(mesh, g) >= 1 && mesh_efficiency(c, g, mesh) > 0;
}

double efficiency(const Choice& c, const Gears& g, bool forward) {
  for (int mesh = 0; mesh < (is_planetary(*c.problem) ? 2 : 3); ++mesh) {
    if (!passes(c, g, mesh)) return 0;
  }
  const double a = mesh_efficiency(c, g, 0), b = mesh_efficiency(c, g, 1);
  const double i1 = real(ring_1(g)) / real(g.sun);
  if (is_planetary(*c.problem)) {
    return forward ? (1 + a * b * i1) / (1 + i1) : (1 + i1) / (1 + i1 / (a * b));
  }
  const double e = mesh_efficiency(c, g, 2);
  const double i2 = real(ring_1(g) * g.second) / real(g.first * ring_2(g));
  if (forward) return (1 + a * b * i1) * (1 - i2) / ((1 + i1) * (1 - b * e * i2));
  return std::max(0.0, a * (1 + i1) * (b * e - i2) / (e * (a * b + i1) * (1 - i2)));
}

struct Body {
  double mass = 0, inertia = 0;
};

Body annulus(const Choice& c, int layer, double outer_mm, double inner_mm) {
  const double width = number(c.problem->face_width_mm.at(layer == 1 ? "layer_1" : "layer_2"));
  const double outer = outer_mm / 1000, inner = inner_mm / 1000;
  const double mass =
      number(*c.problem->density_kg_m3) * kPi / 4 * width / 1000 * (outer * outer - inner * inner);
  return {mass, mass * (outer * outer + inner * inner) / 8};
}

/// Sun, planets (disc 1, disc 2), rings.
struct Bodies {
  Body sun, disc_1, disc_2, ring_1, ring_2;
};

Bodies bodies(const Choice& c, const Gears& g) {
  const double m = c.module_mm, rims = 2 * wall_mm(c);
  const double k = 2 * shaper_addendum(*c.problem) * m + rims;
  const double k_sun = 2 * hob_addendum(*c.problem) * m + rims;
  const bool planetary = is_planetary(*c.problem);
  const double f = m * real(ring_1(g)), o = m * real(ring_2(g));
  return {annulus(c, 1, m * real(g.sun), std::max(0.0, m * real(g.sun) - k_sun)),
          annulus(c, 1, m * real(g.first), 0),
          planetary ? Body{} : annulus(c, 2, m * real(g.second), 0), annulus(c, 1, f + k, f),
          planetary ? Body{} : annulus(c, 2, o + k, o)};
}

double reflected_inertia(const Choice& c, const Gears& g) {
  const Bodies b = bodies(c, g);
  const double i = ratio(c, g), n = real(c.planet_count);
  const double a = c.module_mm / 1000 * real(g.sun + g.first) / 2;
  const double i1 = real(ring_1(g)) / real(g.sun);
  const double carrier = 1 / (1 + i1);
  const double spin = (1 - real(ring_1(g)) / real(g.first)) * carrier;
  const double input = number(c.problem->rotor_inertia_kg_m2) + b.sun.inertia +
                       n * ((b.disc_1.mass + b.disc_2.mass) * a * a * carrier * carrier +
                            (b.disc_1.inertia + b.disc_2.inertia) * spin * spin);
  return i * i * input + b.ring_2.inertia;
}

double paper_cost(const Choice& c, const Gears& g) {
  const double bore = number(c.problem->rotor_inner_diameter_mm) / c.module_mm;
  const auto square = [](double x) { return x * x; };
  return 1 / square(real(g.sun)) + square(real(ring_1(g)) - bore) + square(real(g.first)) +
         square(real(g.second)) + square(real(ring_2(g)));
}

bool holds_in_paper(const std::string& name, const Choice& c, const Gears& g) {
  const Problem& p = *c.problem;
  if (name == "ratio") {
    const double t = number(p.ratio_tolerance) + 1e-12;
    return std::abs(ratio(c, g) / number(p.target_ratio) - 1) <= t;
  }
  if (starts_with(name, "min_teeth.")) {
    return gear(last_part(name), g) >= p.min_teeth.at(last_part(name));
  }
  if (name == "carrier_clearance") {
    return quantity(name, c, g) >= number(p.min_carrier_clearance_rad) - kSlack;
  }
  if (name == "rotor_bore") {
    return real(ring_1(g)) <= number(p.rotor_inner_diameter_mm) / c.module_mm + kSlack;
  }
  if (name == "tooth_difference") return g.first - g.second >= c.planet_count;
  if (name == "equal_spacing") return (g.sun + ring_1(g)) % c.planet_count == 0;
  throw std::invalid_argument(name);
}

}  // namespace

long fewest_fed(const Problem& p) {
  static std::map<std::array<double, 3>, long> known;
  const std::array<double, 3> tool{real(*p.cutters.shaper_teeth), shaper_addendum(p),
                                   number(p.cutters.shaper_tip_radius.value_or(0))};
  if (!known.contains(tool)) known[tool] = simulated_fewest_fed(p);
  return known.at(tool);
}

double number(const Rational& value) {
  // mpq's own conversion truncates; whole numbers this small are exact, their quotient is rounded.
  return value.get_num().get_d() / value.get_den().get_d();
}
bool is_planetary(const Problem& problem) { return problem.topology == "planetary"; }

bool holds(const std::string& name, const Choice& c, const Gears& g) {
  const Problem& p = *c.problem;
  const std::string part = last_part(name);
  if (name == "identical_planets") {
    const long offset = ring_2(g) * g.first - ring_1(g) * g.second;
    return offset % (c.planet_count * std::gcd(g.first, g.second)) == 0;
  }
  if (starts_with(name, "neighbour_clearance.")) {
    return neighbour_mm(c, g, part == "layer_1" ? g.first : g.second) >
           number(p.min_neighbour_clearance_mm) + kSlack;
  }
  if (starts_with(name, "undercut.")) {
    return real(gear(part, g)) >= 2 * undercut_depth(p) / std::pow(std::sin(kAlpha), 2);
  }
  if (name == "sun_under_layer_2") return g.first - g.second > 4;
  if (starts_with(name, "ring_wall.")) {
    return (number(p.ring_outer_diameter_mm.value_or(p.rotor_inner_diameter_mm)) -
            c.module_mm * (real(gear(part, g)) + 2 * shaper_addendum(p))) /
               2 >=
           wall_mm(c) - kSlack;
  }
  if (starts_with(name, "ring_tip.")) return gear(part, g) >= 34;
  const bool second = part == "planet_2_output_ring";
  const long planet = second ? g.second : g.first;
  const long ring = second ? ring_2(g) : ring_1(g);
  if (starts_with(name, "interference.involute.")) {
    return real(planet) / real(ring) - 1 + std::tan(ring_angle(ring)) / std::tan(kAlpha) >= 0;
  }
  if (starts_with(name, "interference.trochoid.")) return trochoid(planet, ring) >= 0;
  if (starts_with(name, "root_form.hob.sun")) {
    const double reach = std::max(path_external(g.sun), path_external(g.first));
    return reach * kPi * std::sin(2 * kAlpha) / 2 <= hob_depth(p);
  }
  if (starts_with(name, "root_form.hob.")) {
    return ring >= 34 && path_ring(ring) * kPi * std::sin(2 * kAlpha) / 2 <= hob_depth(p);
  }
  if (starts_with(name, "root_form.shaper.")) {
    return ring > p.cutters.shaper_teeth.value_or(planet) &&
           path_external(planet) * kPi * std::cos(kAlpha) <= shaper_path(p, planet);
  }
  if (starts_with(name, "shaper_feed.")) return ring >= fewest_fed(p);
  if (starts_with(name, "contact_ratio.")) {
    const int mesh = starts_with(part, "sun") ? 0 : second ? 2 : 1;
    return contact_ratio(mesh, g) >= number(p.min_contact_ratio);
  }
  return holds_in_paper(name, c, g);
}

std::vector<std::string> constraint_names(const Problem& problem) {
  const bool planetary = is_planetary(problem);
  std::vector<std::string> names{"ratio", "min_teeth.sun"};
  const auto add = [&](std::vector<std::string> more) {
    names.insert(names.end(), more.begin(), more.end());
  };
  add(planetary ? std::vector<std::string>{"min_teeth.planet"}
                : std::vector<std::string>{"min_teeth.planet_1", "min_teeth.planet_2"});
  add({"carrier_clearance", "rotor_bore", "equal_spacing"});
  if (!planetary) add({"tooth_difference"});
  if (problem.constraints == ConstraintSet::kPaper) return names;
  add({"neighbour_clearance.layer_1", "undercut.sun"});
  for (const std::string& mesh :
       planetary ? std::vector<std::string>{"planet_ring"}
                 : std::vector<std::string>{"planet_1_fixed_ring", "planet_2_output_ring"}) {
    const StatedCutters& cutters = problem.cutters;
    if (cutters.hob_tip_radius || cutters.hob_addendum) add({"root_form.hob." + mesh});
    if (cutters.shaper_teeth || (cutters.shaper_addendum && cutters.shaper_tip_radius)) {
      add({"root_form.shaper." + mesh});
    }
    if (cutters.shaper_teeth) add({"shaper_feed." + mesh});
  }
  if (problem.cutters.hob_tip_radius && problem.cutters.hob_addendum) {
    add({planetary ? "root_form.hob.sun_planet" : "root_form.hob.sun_planet_1"});
  }
  if (planetary) {
    add({"ring_wall.ring"});
    add({"undercut.planet", "ring_tip.ring", "interference.involute.planet_ring",
         "interference.trochoid.planet_ring", "contact_ratio.sun_planet",
         "contact_ratio.planet_ring"});
    return names;
  }
  add({"ring_wall.fixed_ring", "ring_wall.output_ring"});
  if (problem.sun_under_second_layer) add({"sun_under_layer_2"});
  add({"identical_planets", "neighbour_clearance.layer_2", "undercut.planet_1", "undercut.planet_2",
       "ring_tip.fixed_ring", "ring_tip.output_ring", "interference.involute.planet_1_fixed_ring",
       "interference.involute.planet_2_output_ring", "interference.trochoid.planet_1_fixed_ring",
       "interference.trochoid.planet_2_output_ring", "contact_ratio.sun_planet_1",
       "contact_ratio.planet_1_fixed_ring", "contact_ratio.planet_2_output_ring"});
  return names;
}

double ratio(const Choice& c, const Gears& g) {
  if (is_planetary(*c.problem)) return 2 * real(g.sun + g.first) / real(g.sun);
  return 2 * real(g.first * ring_2(g)) / real(g.sun * (g.first - g.second));
}

double contact_ratio(int mesh, const Gears& g) {
  if (mesh == 0) return path_external(g.sun) + path_external(g.first);
  if (mesh == 1) return path_external(g.first) + path_ring(ring_1(g));
  return path_external(g.second) + path_ring(ring_2(g));
}

bool greater_is_better(const std::string& name) {
  return name == "hollow_shaft" || name == "forward_efficiency" || name == "backward_efficiency" ||
         starts_with(name, "teeth.") || name == "carrier_clearance" || name == "contact_ratio" ||
         name == "neighbour_clearance_mm";
}

double quantity(const std::string& name, const Choice& c, const Gears& g) {
  const Problem& p = *c.problem;
  const bool planetary = is_planetary(p);
  if (name == "paper_cost") return paper_cost(c, g);
  if (name == "hollow_shaft") {
    return c.module_mm * (real(g.sun) - 2 * hob_addendum(p)) - 2 * sun_wall_mm(c);
  }
  if (name == "mass") {
    const Bodies b = bodies(c, g);
    return real(c.planet_count) * (b.disc_1.mass + b.disc_2.mass) + b.sun.mass + b.ring_1.mass +
           b.ring_2.mass;
  }
  if (name == "forward_efficiency" || name == "backward_efficiency") {
    return efficiency(c, g, name == "forward_efficiency");
  }
  if (name == "reflected_inertia") return reflected_inertia(c, g);
  if (starts_with(name, "teeth.")) return real(gear(last_part(name), g));
  if (name == "carrier_clearance") {
    return kPi / real(c.planet_count) - std::asin(real(g.first) / real(g.sun + g.first));
  }
  if (name == "ring_pitch_diameter_mm") return c.module_mm * real(ring_1(g));
  if (name == "ratio_error") return std::abs(ratio(c, g) / number(p.target_ratio) - 1);
  if (name == "ring_blank_diameter_mm") {
    return c.module_mm * (real(ring_1(g)) + 2 * shaper_addendum(p)) + 2 * wall_mm(c);
  }
  if (name == "contact_ratio") {
    const double first = std::min(contact_ratio(0, g), contact_ratio(1, g));
    return planetary ? first : std::min(first, contact_ratio(2, g));
  }
  if (name == "neighbour_clearance_mm") {
    const double first = neighbour_mm(c, g, g.first);
    return planetary ? first : std::min(first, neighbour_mm(c, g, g.second));
  }
  throw std::invalid_argument(name);
}

std::string objective_name(const Problem& problem) {
  switch (problem.objective) {
    case Objective::kPaperCost:
      return "paper_cost";
    case Objective::kMass:
      return "mass";
    case Objective::kHollowShaft:
      return "hollow_shaft";
    case Objective::kForwardEfficiency:
      return "forward_efficiency";
    case Objective::kBackwardEfficiency:
      return "backward_efficiency";
    case Objective::kReflectedInertia:
      return "reflected_inertia";
  }
  return "";
}

}  // namespace torquewright::gearbox::proof_test
