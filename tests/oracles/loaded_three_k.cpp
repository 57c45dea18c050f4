// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/loaded_three_k.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>
#include <vector>

namespace torquewright::oracles {
namespace {

using nlohmann::json;

constexpr double kPi = std::numbers::pi;
constexpr double kAlpha = kPi / 9.0;
constexpr double kNone = std::numeric_limits<double>::infinity();
const double kCos = std::cos(kAlpha), kSin = std::sin(kAlpha), kTan = std::tan(kAlpha);

double inv(double angle) { return std::tan(angle) - angle; }
const double kInv = inv(kAlpha);

double sq(double x) { return x * x; }

/// A sum of how far conditions are missed, in modules or the like.
struct Missed {
  double sum = 0.0;
  void ask(double margin) {
    if (!(margin >= 0.0)) sum += std::isfinite(margin) ? -margin : 10.0;
  }
};

struct Gear {
  double z = 0.0, x = 0.0, tip = 0.0;  ///< Tip diameter in modules.
  double rb() const { return 0.5 * z * kCos; }
  double ra() const { return 0.5 * tip; }
  double at() const { return std::acos(z * kCos / tip); }  ///< Pressure angle at the tip.
};

/// Everything that the problem fixes.
struct Given {
  json problem;
  double load_Nm, cycles, space_mm, density, friction;
  double least_x, most_x, tip_thickness, least_width_mm, contact, neighbour_mm;
  bool has_floor;  ///< Of efficiency.
  explicit Given(const json& p)
      : problem(p),
        load_Nm(p["load"]["output_torque_Nm"]),
        cycles(p["load"].value("cycles", 1e4)),
        space_mm(p.value("ring_outer_diameter_mm", p["rotor_inner_diameter_mm"].get<double>())),
        density(p["materials"]["density_kg_m3"]),
        friction(p.value("friction_coefficient", 0.0)),
        least_x(p["synthesis"]["min_profile_shift"]),
        most_x(p["synthesis"]["max_profile_shift"]),
        tip_thickness(p["synthesis"]["min_tip_thickness"]),
        least_width_mm(p["synthesis"]["min_face_width_mm"]),
        contact(std::max(1.0, p.value("min_contact_ratio", 1.2))),
        neighbour_mm(p.value("min_neighbour_clearance_mm", 0.0)),
        has_floor(p.contains("min_forward_efficiency") || p.contains("min_backward_efficiency")) {}

  double number(const char* key, double otherwise) const { return problem.value(key, otherwise); }
  double wall_mm(double m) const { return problem.value("ring_wall_mm", 2.25 * m); }
  double sharing(std::int64_t n) const {
    return n <= 3 ? 1.1 : n == 4 ? 1.25 : n == 5 ? 1.35 : n == 6 ? 1.44 : 1.47;
  }
  double widest_mm(double m, std::int64_t least_teeth) const {
    const json& s = problem["synthesis"];
    return std::min(
        {s.value("max_face_width_mm", kNone), s.value("max_face_width_over_module", kNone) * m,
         s.value("max_face_width_over_diameter", kNone) * m * static_cast<double>(least_teeth)});
  }
};

// Case-hardened, strength.md: sigma_Flim 430, sigma_Hlim 1500, E 206000, nu 0.3.

double root_limit(const Given& given, double stress_factor, double alternating) {
  const double once = 2.0 * 430.0 * 2.5 * (0.44 * stress_factor + 0.12);
  const double ever = 2.0 * 430.0 * alternating;
  if (given.cycles <= 1e3) return once;
  if (given.cycles >= 3e6) return std::min(once, ever);
  const double way = std::log(given.cycles / 1e3) / std::log(3e6 / 1e3);
  return std::min(once, std::exp(std::log(once) + way * (std::log(ever) - std::log(once))));
}

double flank_limit(const Given& given) {
  if (given.cycles <= 1e5) return 2400.0;
  if (given.cycles >= 5e7) return 1500.0;
  const double way = std::log(given.cycles / 1e5) / std::log(5e7 / 1e5);
  return std::exp(std::log(2400.0) + way * std::log(1500.0 / 2400.0));
}

struct Notch {
  double form, stress;
};

Notch beam(double lever, double chord, double fillet, double force_angle) {
  const double l = chord / lever;
  return {6.0 * lever * std::cos(force_angle) / (sq(chord) * kCos),
          (1.2 + 0.13 * l) * std::pow(chord / (2.0 * fillet), 1.0 / (1.21 + 2.3 / l))};
}

/// DIN 3990-3 of an external tooth, loaded `contact` - 1 base pitches below its tip.
Notch external_notch(const Gear& gear, double rounding, double contact) {
  const double h = 1.25;
  const double g = rounding - h + gear.x;
  const double e = kPi / 4.0 - h * kTan - (1.0 - kSin) * rounding / kCos;
  const double top = 2.0 / gear.z * (kPi / 2.0 - e) - kPi / 3.0;
  double theta = kPi / 6.0;
  for (int i = 0; i < 60; ++i) theta = 2.0 * g / gear.z * std::tan(theta) - top;
  const double chord =
      gear.z * std::sin(kPi / 3.0 - theta) + std::sqrt(3.0) * (g / std::cos(theta) - rounding);
  const double reach = std::sqrt(sq(gear.ra()) - sq(gear.rb())) - kPi * kCos * (contact - 1.0);
  const double de = 2.0 * std::sqrt(sq(reach) + sq(gear.rb()));
  const double ae = std::acos(2.0 * gear.rb() / de);
  const double ge = (kPi / 2.0 + 2.0 * gear.x * kTan) / gear.z + kInv - inv(ae);
  const double lever =
      0.5 * ((std::cos(ge) - std::sin(ge) * std::tan(ae - ge)) * de -
             gear.z * std::cos(kPi / 3.0 - theta) - g / std::cos(theta) + rounding);
  const double fillet =
      rounding + 2.0 * sq(g) / (std::cos(theta) * (gear.z * sq(std::cos(theta)) - 2.0 * g));
  return beam(lever, chord, fillet, ae - ge);
}

/// Two gears at their centre distance, in modules.
struct Pair {
  bool inside;
  Gear first, second;
  double centre, angle;

  double path_end(bool of_second) const {
    const double sign = of_second && inside ? -1.0 : 1.0;
    const Gear& gear = of_second ? second : first;
    return sign * gear.z * (std::tan(gear.at()) - std::tan(angle)) / (2.0 * kPi);
  }
  double contact() const { return path_end(false) + path_end(true); }
  /// String from the base circle of an external gear to where the mate's tip touches it.
  double deepest(bool of_second) const {
    const Gear& mate = of_second ? first : second;
    const double tip = std::sqrt(sq(mate.ra()) - sq(mate.rb()));
    return inside ? tip - centre * std::sin(angle) : centre * std::sin(angle) - tip;
  }
};

/// tooth_outline.md (8), (9).
double largest_hob(const Gear& gear, double string) {
  const double depth = gear.x + kSin * (0.5 * gear.z * kSin - string);
  return (1.25 - depth) / (1.0 - kSin);
}

double thickness(const Gear& gear, bool inside) {
  const double half = (kPi / 2.0 + 2.0 * gear.x * kTan) / gear.z + kInv - inv(gear.at());
  return gear.tip * (inside ? kPi / gear.z - half : half);
}

/// The shaper of a ring: as many teeth as the planet.
struct Tool {
  bool fits = false;
  double q = 0.0, centre = 0.0, angle = 0.0, tip = 0.0, largest = 0.0, rounding = 0.0;
};

double land(const Tool& tool, double rounding) {
  const double b = 0.5 * tool.q * kCos;
  return kPi / (2.0 * tool.q) + kInv - inv(std::acos(b / (tool.tip - rounding))) - rounding / b;
}

double inverse_involute(double value) {
  double low = 0.0, high = 1.5;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (inv(middle) < value ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

Tool tool_of(const Pair& pair) {
  Tool tool;
  tool.q = pair.first.z;
  const Gear& ring = pair.second;
  const double between = ring.z - tool.q;
  const double involute = kInv + 2.0 * ring.x * kTan / between;
  if (!(involute >= 0.0)) return tool;
  tool.angle = inverse_involute(involute);
  tool.centre = 0.5 * between * kCos / std::cos(tool.angle);
  tool.tip = 0.5 * ring.z + ring.x + 1.25 - tool.centre;
  const double b = 0.5 * tool.q * kCos;
  if (!(tool.tip > b) || !(land(tool, 0.0) >= 0.0)) return tool;
  const double c = pair.centre * std::sin(pair.angle) +
                   std::sqrt(sq(pair.first.ra()) - sq(pair.first.rb())) -
                   tool.centre * std::sin(tool.angle);
  tool.largest = (sq(tool.tip) - sq(b) - sq(c)) / (2.0 * (tool.tip - c));
  tool.rounding = std::max(0.0, std::min(0.3, tool.largest));
  if (land(tool, tool.rounding) < 0.0) {
    double low = 0.0, high = tool.rounding;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (land(tool, middle) >= 0.0 ? low : high) = middle;
    }
    tool.rounding = low;
  }
  tool.fits = tool.tip - tool.rounding > b;
  return tool;
}

/// The section (6) at a share of the trochoid's turn, by the curve's points and differences.
Notch ring_notch_at(const Gear& ring, const Tool& tool, double share) {
  const double k = tool.q / ring.z;
  const double b = 0.5 * tool.q * kCos;
  const double arm = tool.tip - tool.rounding;
  const double beta = land(tool, tool.rounding);
  const double pitch = 0.5 * ring.z * kCos / std::cos(tool.angle);
  const double end = std::acos(b / arm) - tool.angle;
  const auto cut = [&](double phi) {
    const double kx = tool.centre + arm * std::cos(phi), ky = arm * std::sin(phi);
    const double far = std::hypot(kx - pitch, ky);
    const double px = kx + tool.rounding * (kx - pitch) / far;
    const double py = ky + tool.rounding * ky / far;
    const double turn = -(phi - beta) * k;
    return std::pair{px * std::cos(turn) - py * std::sin(turn),
                     px * std::sin(turn) + py * std::cos(turn)};
  };
  const double phi = share * end;
  const double step = 1e-4;
  const auto [x0, y0] = cut(phi - step);
  const auto [x1, y1] = cut(phi);
  const auto [x2, y2] = cut(phi + step);
  const double dx = (x2 - x0) / 2.0, dy = (y2 - y0) / 2.0;
  const double ddx = x2 - 2.0 * x1 + x0, ddy = y2 - 2.0 * y1 + y0;
  const double radius = std::pow(sq(dx) + sq(dy), 1.5) / std::abs(dx * ddy - dy * ddx);
  const double big = std::hypot(x1, y1);
  const double v = kPi / ring.z - std::atan2(y1, x1);
  const double delta =
      kPi / ring.z - ((kPi / 2.0 + 2.0 * ring.x * kTan) / ring.z + kInv - inv(ring.at()));
  const double force = ring.at() + delta;
  const double crossing = ring.ra() * (std::cos(delta) + std::sin(delta) * std::tan(force));
  return beam(big * std::cos(v) - crossing, 2.0 * big * std::sin(v), radius, force);
}

Notch ring_notch(const Gear& ring, const Tool& tool) {
  if (!tool.fits) {  // DIN 3990 D.5.05, D.5.15, D.5.16: a rack's tooth, half the tool's rounding.
    const double r = 0.3, s30 = std::sin(kPi / 6.0), c30 = std::cos(kPi / 6.0);
    const double chord = 2.0 * (kPi / 4.0 + kTan * (1.25 - r) + r / kCos - r * c30);
    const double lever = 2.25 - (kPi / 4.0 + (1.25 - 2.25) * kTan) * kTan - r * (1.0 - s30);
    return beam(lever, chord, r / 2.0, kAlpha);
  }
  const auto at = [&](double share) { return ring_notch_at(ring, tool, share); };
  const auto product = [](const Notch& notch) { return notch.form * notch.stress; };
  constexpr int kPlaces = 12;
  int best = 0;
  double most = 0.0;
  for (int i = 0; i <= kPlaces; ++i) {
    const double here = product(at(i / double{kPlaces}));
    if (here > most) {
      most = here;
      best = i;
    }
  }
  double low = std::max(0.0, (best - 1) / double{kPlaces});
  double high = std::min(1.0, (best + 1) / double{kPlaces});
  for (int i = 0; i < 12; ++i) {
    const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
    (product(at(a)) < product(at(b)) ? low : high) = product(at(a)) < product(at(b)) ? a : b;
  }
  const Notch inside = at(0.5 * (low + high)), edge = at(best / double{kPlaces});
  return product(inside) > product(edge) ? inside : edge;
}

/// A layer at a place: how far it misses conditions, what width it needs, what it weighs.
struct Layer {
  double missed = 1e9;
  double width_mm = 0.0;
  double mass_kg = kNone;
  double inertia_kg_m2 = 0.0;  ///< Of what turns, seen from the output.
  std::array<double, 2> efficiency{1.0, 1.0};
  double sun_shift = 0.0;
};

/// Speeds with the carrier at 1; `output_ring`: 1 or 2, the carrier: 0.
struct Motion {
  double sun = 0.0, planet = 0.0, ring_1 = 0.0, ring_2 = 0.0;
  int output_ring = 0;
  double output() const { return output_ring == 0 ? 1.0 : output_ring == 1 ? ring_1 : ring_2; }
};

/// By rolling without slip in every mesh: z (w - 1) = -+ p (w_P - 1), the held ring at 0.
Motion motion_of(const LoadedTeeth& z, const std::string& topology) {
  const auto whole = [](std::int64_t number) { return static_cast<double>(number); };
  const bool holds_first = topology == "3k" || topology == "planetary";
  const double spin =
      holds_first ? -whole(z.ring_1) / whole(z.planet_1) : -whole(z.ring_2) / whole(z.planet_2);
  Motion motion;
  motion.planet = 1.0 + spin;
  motion.sun = 1.0 - spin * whole(z.planet_1) / whole(z.sun);
  const auto ring = [&](std::int64_t planet, std::int64_t teeth) {
    return teeth > 0 ? 1.0 + spin * whole(planet) / whole(teeth) : 0.0;
  };
  motion.ring_1 = holds_first ? 0.0 : ring(z.planet_1, z.ring_1);
  motion.ring_2 = holds_first ? ring(z.planet_2, z.ring_2) : 0.0;
  motion.output_ring = topology == "3k" ? 2 : topology == "3k_b" ? 1 : 0;
  return motion;
}

class Train {
 public:
  Train(const Given& given, const LoadedTeeth& teeth) : given_(given), z_(teeth) {
    const double s = whole(z_.sun), n = whole(z_.planets);
    const double r1 = whole(z_.ring_1), r2 = whole(z_.ring_2);
    const Motion motion = motion_of(teeth, given.problem["topology"]);
    const double ratio = motion.sun / motion.output();
    const double sun_Nm = given.load_Nm / ratio;
    const auto force = [&](double ring_speed, double m, double z) {
      const double torque_Nm = ring_speed == 0.0 ? given.load_Nm - sun_Nm : given.load_Nm;
      return z > 0.0 ? 2e3 * torque_Nm / (n * m * z) : 0.0;
    };
    force_S_ = 2e3 * sun_Nm / (n * z_.module_1_mm * s);
    force_F_ = force(motion.ring_1, z_.module_1_mm, r1);
    force_O_ = force(motion.ring_2, z_.module_2_mm, r2);
    // The carrier at 1: what a central gear turns against it, planets rolling.
    ratio_1_ = motion.sun - 1.0;
    ratio_2_ = motion.output_ring > 0 ? 1.0 - motion.output() : 0.0;
    held_ = motion.ring_1 == 0.0 && r1 > 0.0 ? 1 : 2;
    output_ring_ = static_cast<std::size_t>(motion.output_ring);
    // Speeds over the output's: of the sun, the carrier, a planet about its own axis, the rings.
    sun_speed_ = ratio;
    carrier_speed_ = 1.0 / motion.output();
    planet_speed_ = motion.planet / motion.output();
    ring_1_speed_ = motion.ring_1 / motion.output();
    ring_2_speed_ = motion.ring_2 / motion.output();
    // Planet 1 is pushed on both flanks where the ring beside it is held.
    alternating_ = held_ == 1 ? 0.7 : 1.0;
  }

  std::pair<double, double> centres_mm() const {
    const double between = whole(z_.sun + z_.planet_1);
    const auto centre = [&](double shifts) {
      const double value = std::max(0.0, kInv + 2.0 * kTan * shifts / between);
      return 0.5 * z_.module_1_mm * between * kCos / std::cos(inverse_involute(value));
    };
    return {centre(2.0 * given_.least_x), centre(2.0 * given_.most_x)};
  }

  Layer first(double centre_mm, double x1) const {
    if (z_.ring_1 == 0) return sun_and_planets(centre_mm, x1);
    Layer layer;
    const double m = z_.module_1_mm, a = centre_mm / m;
    const double s = whole(z_.sun), p = whole(z_.planet_1), f = whole(z_.ring_1);
    const double cos_out = 0.5 * (s + p) * kCos / a, cos_in = 0.5 * (f - p) * kCos / a;
    if (!(cos_out < 1.0) || !(cos_in < 1.0)) return layer;
    const double out = std::acos(cos_out), in = std::acos(cos_in);
    const double y = a - 0.5 * (s + p);
    const double xs = (s + p) * (inv(out) - kInv) / (2.0 * kTan) - x1;
    const double xf = x1 + (f - p) * (inv(in) - kInv) / (2.0 * kTan);
    const Gear sun{s, xs, s + 2.0 * (1.0 + y - x1)};
    const Gear planet{p, x1, p + 2.0 * std::min(1.0 + y - xs, 1.0 + x1)};
    const Gear ring{f, xf, f - 2.0 * (1.0 - xf)};
    layer.sun_shift = xs;
    const Pair outside{false, sun, planet, a, out};
    const Pair within{true, planet, ring, a, in};
    Missed missed;
    ask_ring(within, m, missed);
    ask_sun(outside, m, missed);
    const double hob_s = largest_hob(sun, outside.deepest(false));
    const double hob_p = largest_hob(planet, outside.deepest(true));
    const double hob_1 = rounding(std::min(hob_p, largest_hob(planet, within.deepest(false))));
    const Tool tool = tool_of(within);
    double width =
        std::max({given_.least_width_mm, flank_mm(within, force_F_, m, false),
                  flank_mm(outside, force_S_, m, false), flank_mm(outside, force_S_, m, true),
                  root_mm(planet, hob_1, within.contact(), force_F_, m, alternating_),
                  root_mm(planet, hob_1, outside.contact(), force_S_, m, alternating_),
                  root_mm(sun, rounding(hob_s), outside.contact(), force_S_, m, 1.0),
                  ring_mm(ring, tool, within.contact(), force_F_, m)});
    missed.ask(given_.widest_mm(m, std::min(z_.sun, z_.planet_1)) - width);
    layer.efficiency = {efficiency(outside), efficiency(within)};
    const double rim = 1e-3 * (2.5 * m + 2.0 * given_.wall_mm(m));
    const double size = 1e-3 * m * (s + 2.0 * xs);
    const double area =
        planets_area(planet, m) + ring_area(ring, m) + sq(size) - sq(std::max(0.0, size - rim));
    finish(layer, missed, width, area);
    layer.inertia_kg_m2 =
        turning(width, size, std::max(0.0, size - rim), sun_speed_) + planets(width, planet, m, a);
    const double inner = 1e-3 * m * (f + 2.0 * xf);
    layer.inertia_kg_m2 += turning(width, inner + rim, inner, ring_1_speed_);
    return layer;
  }

  /// The first layer of a compound train: no ring is around it.
  Layer sun_and_planets(double centre_mm, double x1) const {
    Layer layer;
    const double m = z_.module_1_mm, a = centre_mm / m;
    const double s = whole(z_.sun), p = whole(z_.planet_1);
    const double cosine = 0.5 * (s + p) * kCos / a;
    if (!(cosine < 1.0)) return layer;
    const double out = std::acos(cosine), y = a - 0.5 * (s + p);
    const double xs = (s + p) * (inv(out) - kInv) / (2.0 * kTan) - x1;
    const Gear sun{s, xs, s + 2.0 * (1.0 + y - x1)};
    const Gear planet{p, x1, p + 2.0 * std::min(1.0 + y - xs, 1.0 + x1)};
    layer.sun_shift = xs;
    const Pair outside{false, sun, planet, a, out};
    Missed missed;
    ask_planet(planet, a, m, missed);
    missed.ask((given_.space_mm - 2.0 * m * (a + planet.ra())) / m);
    ask_sun(outside, m, missed);
    const double hob_s = rounding(largest_hob(sun, outside.deepest(false)));
    const double hob_p = rounding(largest_hob(planet, outside.deepest(true)));
    const double width = std::max({given_.least_width_mm, flank_mm(outside, force_S_, m, false),
                                   flank_mm(outside, force_S_, m, true),
                                   root_mm(planet, hob_p, outside.contact(), force_S_, m, 1.0),
                                   root_mm(sun, hob_s, outside.contact(), force_S_, m, 1.0)});
    missed.ask(given_.widest_mm(m, std::min(z_.sun, z_.planet_1)) - width);
    layer.efficiency = {efficiency(outside), 1.0};
    const double rim = 1e-3 * (2.5 * m + 2.0 * given_.wall_mm(m));
    const double size = 1e-3 * m * (s + 2.0 * xs), bore = std::max(0.0, size - rim);
    finish(layer, missed, width, planets_area(planet, m) + sq(size) - sq(bore));
    layer.inertia_kg_m2 = turning(width, size, bore, sun_speed_) + planets(width, planet, m, a);
    return layer;
  }

  Layer second(double centre_mm, double x2) const {
    Layer layer;
    if (z_.planet_2 == 0) {
      layer.missed = layer.mass_kg = 0.0;
      return layer;
    }
    const double m = z_.module_2_mm, a = centre_mm / m;
    const double p = whole(z_.planet_2), o = whole(z_.ring_2);
    const double cosine = 0.5 * (o - p) * kCos / a;
    if (!(cosine < 1.0)) return layer;
    const double in = std::acos(cosine);
    const double xo = x2 + (o - p) * (inv(in) - kInv) / (2.0 * kTan);
    const Gear planet{p, x2, p + 2.0 * (1.0 + x2)};
    const Gear ring{o, xo, o - 2.0 * (1.0 - xo)};
    const Pair within{true, planet, ring, a, in};
    Missed missed;
    ask_ring(within, m, missed);
    const double hob = rounding(largest_hob(planet, within.deepest(false)));
    const Tool tool = tool_of(within);
    const double width = std::max({given_.least_width_mm, flank_mm(within, force_O_, m, false),
                                   root_mm(planet, hob, within.contact(), force_O_, m, 1.0),
                                   ring_mm(ring, tool, within.contact(), force_O_, m)});
    missed.ask(given_.widest_mm(m, z_.planet_2) - width);
    layer.efficiency = {efficiency(within), 1.0};
    finish(layer, missed, width, planets_area(planet, m) + ring_area(ring, m));
    const double inner = 1e-3 * m * (o + 2.0 * xo);
    const double outer = inner + 1e-3 * (2.5 * m + 2.0 * given_.wall_mm(m));
    layer.inertia_kg_m2 =
        turning(width, outer, inner, ring_2_speed_) + planets(width, planet, m, a);
    return layer;
  }

  /// How far both together miss what binds them.
  double missed_by(const Layer& first, const Layer& second, double x1, double x2) const {
    Missed missed;
    if (z_.planet_2 > 0 && given_.problem["topology"] != "3k_b" &&
        given_.problem.value("sun_under_second_layer", true)) {
      missed.ask(z_.module_1_mm * (0.5 * whole(z_.planet_1) - 1.0 + x1) -
                 z_.module_2_mm * (0.5 * whole(z_.planet_2) + 1.0 + x2));
    }
    missed.ask(given_.number("max_axial_length_mm", kNone) - first.width_mm - second.width_mm);
    const std::array<double, 2> rings{first.efficiency[1], second.efficiency[0]};
    const double a = first.efficiency[0], b = rings[held_ - 1];
    const double c = output_ring_ > 0 ? rings[output_ring_ - 1] : 1.0;
    double forward =
        (1.0 + a * b * ratio_1_) * (1.0 - ratio_2_) / ((1.0 + ratio_1_) * (1.0 - b * c * ratio_2_));
    double backward =
        a * (1.0 + ratio_1_) * (b * c - ratio_2_) / (c * (a * b + ratio_1_) * (1.0 - ratio_2_));
    if (output_ring_ == 0) {
      forward = (1.0 + a * b * ratio_1_) / (1.0 + ratio_1_);
      backward = (1.0 + ratio_1_) / (1.0 + ratio_1_ / (a * b));
    }
    const double rotor_kg_m2 = given_.number("rotor_inertia_kg_m2", 0.0) * sq(sun_speed_);
    const double inertia_kg_m2 = rotor_kg_m2 + first.inertia_kg_m2 + second.inertia_kg_m2;
    missed.ask(1.0 - (first.mass_kg + second.mass_kg) / given_.number("max_mass_kg", kNone));
    missed.ask(1.0 - inertia_kg_m2 / given_.number("max_reflected_inertia_kg_m2", kNone));
    missed.ask(forward - given_.number("min_forward_efficiency", -kNone));
    missed.ask(backward - given_.number("min_backward_efficiency", -kNone));
    return missed.sum;
  }

 private:
  static double whole(std::int64_t number) { return static_cast<double>(number); }
  static double rounding(double largest) { return std::max(0.0, std::min(0.38, largest)); }

  void ask_planet(const Gear& planet, double centre, double m, Missed& missed) const {
    missed.ask((2.0 * centre * m * std::sin(kPi / whole(z_.planets)) - m * planet.tip -
                given_.neighbour_mm) /
               m);
    missed.ask(planet.x - (1.0 - 0.5 * planet.z * sq(kSin)));
    missed.ask(planet.x - given_.least_x);
    missed.ask(given_.most_x - planet.x);
    missed.ask(thickness(planet, false) - given_.tip_thickness);
  }

  void ask_sun(const Pair& pair, double m, Missed& missed) const {
    const Gear& sun = pair.first;
    const Gear& planet = pair.second;
    missed.ask(sun.x - given_.least_x);
    missed.ask(given_.most_x - sun.x);
    missed.ask(sun.x - (1.0 - 0.5 * sun.z * sq(kSin)));
    missed.ask(pair.contact() - given_.contact);
    missed.ask(pair.deepest(false));
    missed.ask(pair.deepest(true));
    missed.ask(thickness(sun, false) - given_.tip_thickness);
    missed.ask(largest_hob(sun, pair.deepest(false)));
    missed.ask(largest_hob(planet, pair.deepest(true)));
    missed.ask(pair.centre - planet.ra() - (0.5 * sun.z + sun.x - 1.25));
    missed.ask(pair.centre - sun.ra() - (0.5 * planet.z + planet.x - 1.25));
    const double shaft = given_.number("min_hollow_shaft_diameter_mm", -kNone);
    const double shaft_wall = given_.number("hollow_shaft_wall_mm", given_.wall_mm(m));
    missed.ask(m * (sun.z + 2.0 * sun.x - 2.5) - 2.0 * shaft_wall - shaft);
  }

  void ask_ring(const Pair& pair, double m, Missed& missed) const {
    const Gear& planet = pair.first;
    const Gear& ring = pair.second;
    ask_planet(planet, pair.centre, m, missed);
    missed.ask((given_.space_mm - m * (ring.z + 2.0 * ring.x + 2.5)) / (2.0 * m) -
               given_.wall_mm(m) / m);
    missed.ask(ring.tip - ring.z * kCos);
    if (!(ring.tip > ring.z * kCos)) return;
    missed.ask(planet.z / ring.z - 1.0 + std::tan(ring.at()) / std::tan(pair.angle));
    const double a = pair.centre, r1 = planet.ra(), r2 = ring.ra();
    const double first =
        std::acos((sq(r2) - sq(r1) - sq(a)) / (2.0 * a * r1)) + inv(planet.at()) - inv(pair.angle);
    const double second = std::acos((sq(a) + sq(r2) - sq(r1)) / (2.0 * a * r2));
    missed.ask(first * planet.z / ring.z + inv(pair.angle) - inv(ring.at()) - second);
    missed.ask(pair.contact() - given_.contact);
    missed.ask(largest_hob(planet, pair.deepest(false)));
    missed.ask(thickness(ring, true) - given_.tip_thickness);
    const Tool tool = tool_of(pair);
    if (tool.fits) missed.ask(tool.largest);
    missed.ask(r2 - a - (0.5 * planet.z + planet.x - 1.25));
    missed.ask(0.5 * ring.z + ring.x + 1.25 - a - r1);
  }

  /// (4), (5): the width in mm at which the root bears the load with the safety 1.4.
  double root_stress_mm(const Notch& tip, double limit, double contact, double force,
                        double m) const {
    const double factors = given_.sharing(z_.planets) * 1.2 * 1.4;
    return force / m * tip.form * tip.stress * (0.25 + 0.75 / contact) * factors / limit;
  }

  double root_mm(const Gear& gear, double rounding, double contact, double force, double m,
                 double alternating) const {
    const Notch tip = external_notch(gear, rounding, 1.0);
    const Notch outer = external_notch(gear, rounding, std::min(contact, 2.0));
    return root_stress_mm(tip, root_limit(given_, outer.stress, alternating), contact, force, m);
  }

  double ring_mm(const Gear& ring, const Tool& tool, double contact, double force, double m) const {
    if (!(ring.tip > ring.z * kCos)) return kNone;
    const Notch notch = ring_notch(ring, tool);
    return root_stress_mm(notch, root_limit(given_, notch.stress, 1.0), contact, force, m);
  }

  /// (7)...(10) by Hertz's pressure at the inner point of single contact or the pitch point;
  /// `swap`: of the second gear.
  double flank_mm(const Pair& pair, double force, double m, bool swap) const {
    const double sign = pair.inside ? -1.0 : 1.0;
    const Gear& one = swap ? pair.second : pair.first;
    const Gear& two = swap ? pair.first : pair.second;
    const double base_pitch = kPi * kCos;
    const double whole_path = pair.centre * std::sin(pair.angle);
    const double rho_1 = std::sqrt(sq(one.ra()) - sq(one.rb())) - base_pitch;
    const double rho_2 = pair.inside ? whole_path + rho_1 : whole_path - rho_1;
    const double w1 = one.rb() * std::tan(pair.angle), w2 = two.rb() * std::tan(pair.angle);
    const double zb2 = std::max(1.0, w1 * w2 / (rho_1 * rho_2));
    const double ze2 = 1.0 / (kPi * 2.0 * (1.0 - 0.09) / 206000.0);
    const double zh2 = 2.0 * std::cos(pair.angle) / (sq(kCos) * std::sin(pair.angle));
    const double ze_contact = std::max(0.0, 4.0 - pair.contact()) / 3.0;
    const double u = pair.second.z / pair.first.z;
    const double square = ze2 * zh2 * ze_contact * force / (pair.first.z * m) * (u + sign) / u;
    return zb2 * square * given_.sharing(z_.planets) * 1.3 / sq(flank_limit(given_));
  }

  double efficiency(const Pair& pair) const {
    if (!given_.has_floor) return 1.0;
    const double from = -pair.path_end(true), to = pair.path_end(false);
    if (!(to > from)) return 0.0;
    double sum = 0.0;
    constexpr int kParts = 2000;
    for (int i = 0; i < kParts; ++i) {
      const double x = from + (to - from) * (i + 0.5) / kParts;
      const double pairs = std::floor(to - x) + std::floor(x - from) + 1.0;
      sum += std::abs(x) / pairs;
    }
    sum *= 2.0 * (to - from) / kParts;
    const double sign = pair.inside ? -1.0 : 1.0;
    return 1.0 - given_.friction * kPi * (1.0 / pair.first.z + sign / pair.second.z) * sum;
  }

  double planets_area(const Gear& planet, double m) const {
    return whole(z_.planets) * sq(1e-3 * m * (planet.z + 2.0 * planet.x));
  }
  double ring_area(const Gear& ring, double m) const {
    const double inner = 1e-3 * m * (ring.z + 2.0 * ring.x);
    return sq(inner + 1e-3 * (2.5 * m + 2.0 * given_.wall_mm(m))) - sq(inner);
  }

  double weight_kg(double width, double outer_m, double inner_m) const {
    return given_.density * kPi / 4.0 * (sq(outer_m) - sq(inner_m)) * width * 1e-3;
  }
  /// Twice the energy of an annulus that turns with a speed over the output's.
  double turning(double width, double outer_m, double inner_m, double speed) const {
    return weight_kg(width, outer_m, inner_m) * (sq(outer_m) + sq(inner_m)) / 8.0 * sq(speed);
  }
  /// Of the planets, which run with the carrier besides.
  double planets(double width, const Gear& planet, double m, double centre) const {
    const double size = 1e-3 * m * (planet.z + 2.0 * planet.x);
    return whole(z_.planets) *
           (turning(width, size, 0.0, planet_speed_) +
            weight_kg(width, size, 0.0) * sq(1e-3 * m * centre) * sq(carrier_speed_));
  }

  void finish(Layer& layer, const Missed& missed, double width, double area) const {
    layer.missed = missed.sum;
    layer.width_mm = width;
    const double mass = given_.density * kPi / 4.0 * area * width * 1e-3;
    if (std::isfinite(mass)) layer.mass_kg = mass;
  }

  const Given& given_;
  LoadedTeeth z_;
  double force_S_, force_F_, force_O_, ratio_1_, ratio_2_;
  double sun_speed_, carrier_speed_, planet_speed_, ring_1_speed_, ring_2_speed_;
  double alternating_;
  std::size_t held_ = 1, output_ring_ = 0;  ///< Layers, counted from 1; the carrier: 0.
};

/// The continuous problem of one choice.
class Descent {
 public:
  Descent(const Given& given, const LoadedTeeth& teeth, int steps)
      : given_(given), teeth_(teeth), train_(given, teeth), steps_(steps) {}

  std::optional<LoadedTrain> run(double light_enough) {
    const auto [low, high] = train_.centres_mm();
    for (int i = 0; i <= steps_; ++i) consider_centre(low + (high - low) * i / steps_);
    std::sort(starts_.begin(), starts_.end(), better);
    const std::size_t most = std::min<std::size_t>(starts_.size(), 6);
    if (most == 0 || (starts_[0].missed == 0.0 && starts_[0].mass > 1.25 * light_enough)) {
      return std::nullopt;
    }
    Place best = starts_[0];
    for (std::size_t i = 0; i < most; ++i) {
      const Place place =
          down_from(starts_[i], (high - low) / steps_, (given_.most_x - given_.least_x) / steps_);
      if (better(place, best)) best = place;
    }
    if (best.missed > 0.0) return std::nullopt;
    return LoadedTrain{teeth_,
                       best.at[0],
                       best.at[1],
                       best.at[2],
                       {train_.first(best.at[0], best.at[1]).width_mm,
                        train_.second(best.at[0], best.at[2]).width_mm},
                       best.mass};
  }

 private:
  struct Place {
    std::array<double, 3> at{};
    double missed = 1e9, mass = kNone;
  };

  static bool better(const Place& one, const Place& two) {
    return one.missed != two.missed ? one.missed < two.missed : one.mass < two.mass;
  }

  void consider_centre(double centre_mm) {
    std::vector<std::pair<double, Layer>> first, second;
    for (int i = 0; i <= steps_; ++i) {
      const double x = given_.least_x + (given_.most_x - given_.least_x) * i / steps_;
      first.emplace_back(x, train_.first(centre_mm, x));
      second.emplace_back(x, train_.second(centre_mm, x));
    }
    Place best;
    for (const auto& [x1, one] : first) {
      for (const auto& [x2, two] : second) {
        const Place here{{centre_mm, x1, x2},
                         one.missed + two.missed + train_.missed_by(one, two, x1, x2),
                         one.mass_kg + two.mass_kg};
        if (better(here, best)) best = here;
      }
    }
    if (best.missed < 1e8) starts_.push_back(best);
  }

  Place at(const std::array<double, 3>& p) const {
    const Layer one = train_.first(p[0], p[1]), two = train_.second(p[0], p[2]);
    return {p, one.missed + two.missed + train_.missed_by(one, two, p[1], p[2]),
            one.mass_kg + two.mass_kg};
  }

  /// Tries all 26 neighbours, and halves the step where none is better.
  Place down_from(Place place, double centre_step, double shift_step) const {
    for (int halvings = 0; halvings < 22;) {
      Place best = place;
      for (int i = 0; i < 27; ++i) {
        const std::array<double, 3> next{place.at[0] + (i % 3 - 1) * centre_step,
                                         place.at[1] + (i / 3 % 3 - 1) * shift_step,
                                         place.at[2] + (i / 9 - 1) * shift_step};
        const Place here = at(next);
        if (better(here, best)) best = here;
      }
      if (better(best, place)) {
        place = best;
        continue;
      }
      centre_step *= 0.5;
      shift_step *= 0.5;
      ++halvings;
    }
    return place;
  }

  const Given& given_;
  LoadedTeeth teeth_;
  Train train_;
  int steps_;
  std::vector<Place> starts_;
};

template <class Number>
std::vector<Number> list_of(const json& value) {
  if (value.is_array()) return value.get<std::vector<Number>>();
  return {value.get<Number>()};
}

/// Is the ratio of whole numbers a/b within the problem's, to what doubles tell?
bool has_ratio(const json& problem, double a, double b) {
  const double target = problem["target_ratio"], part = problem.value("ratio_tolerance", 0.0);
  return std::abs(a / b - target) <= std::abs(target) * part + 1e-9 * std::abs(target);
}

/// The output's angle, sun and held ring still, for a backlash of 1 mm along every mesh's line of
/// action: of each mesh alone, added up. With base radii r the carrier's psi and a planet's x in it
/// solve r_S psi + r_1 x = j_S, r_h psi - r_p x = j_h; an output ring turns by psi - r_q x/r_O +
/// j_O/r_O.
double backlash(const LoadedTeeth& z, const std::string& topology) {
  const auto base = [](double m, std::int64_t teeth) {
    return 0.5 * m * kCos * static_cast<double>(teeth);
  };
  const bool holds_first = topology == "3k" || topology == "planetary";
  const double sun = base(z.module_1_mm, z.sun), planet_1 = base(z.module_1_mm, z.planet_1);
  const double planet_2 = base(z.module_2_mm, z.planet_2);
  const double ring_1 = base(z.module_1_mm, z.ring_1), ring_2 = base(z.module_2_mm, z.ring_2);
  const double held = holds_first ? ring_1 : ring_2;
  const double beside_held = holds_first ? planet_1 : planet_2;
  const double determinant = -sun * beside_held - held * planet_1;
  // Columns of the inverse: psi and x for j_S = 1, and for j_h = 1.
  const double psi_sun = -beside_held / determinant, x_sun = -held / determinant;
  const double psi_held = -planet_1 / determinant, x_held = sun / determinant;
  const bool has_output = topology == "3k" || topology == "3k_b";
  if (!has_output) return std::abs(psi_sun) + std::abs(psi_held);
  const double output = holds_first ? ring_2 : ring_1;
  const double roll = (holds_first ? planet_2 : planet_1) / output;
  return std::abs(psi_sun - roll * x_sun) + std::abs(psi_held - roll * x_held) + 1.0 / output;
}

std::int64_t most_in_bore(const json& p, double m) {
  return static_cast<std::int64_t>(
      std::floor(p["rotor_inner_diameter_mm"].get<double>() / m + 1e-9));
}

void each_single_stage(const json& p, const std::function<void(const LoadedTeeth&)>& visit) {
  const std::int64_t off = p["synthesis"]["ring_teeth_off"];
  for (const std::int64_t n : list_of<std::int64_t>(p["planet_count"])) {
    for (const double m : list_of<double>(p["module_mm"])) {
      const auto most = static_cast<std::int64_t>(
          std::floor(p["rotor_inner_diameter_mm"].get<double>() / m + 1e-9));
      for (std::int64_t s = p["min_teeth"]["sun"]; s <= most; ++s) {
        for (std::int64_t q = p["min_teeth"]["planet"]; q <= most; ++q) {
          for (std::int64_t r = s + 2 * q - off; r <= std::min(most, s + 2 * q + off); ++r) {
            const double gap = kPi / static_cast<double>(n) -
                               std::asin(static_cast<double>(q) / static_cast<double>(s + q));
            if (gap < p["min_carrier_clearance_rad"].get<double>() - 1e-12) continue;
            if ((s + r) % n != 0) continue;
            if (has_ratio(p, static_cast<double>(s + r), static_cast<double>(s))) {
              visit({s, q, 0, r, 0, n, m, m});
            }
          }
        }
      }
    }
  }
}

void each_choice(const json& p, const std::function<void(const LoadedTeeth&)>& visit) {
  const double bore = p["rotor_inner_diameter_mm"];
  const std::int64_t off = p["synthesis"]["ring_teeth_off"];
  const json second = p["synthesis"].value("layer_2_module_mm", json());
  const json& least = p["min_teeth"];
  for (const std::int64_t n : list_of<std::int64_t>(p["planet_count"])) {
    for (const double m1 : list_of<double>(p["module_mm"])) {
      for (const double m2 : second.is_null() ? std::vector{m1} : list_of<double>(second)) {
        const auto most = static_cast<std::int64_t>(std::floor(bore / m1 + 1e-9));
        for (std::int64_t s = least["sun"]; s <= most; ++s) {
          for (std::int64_t p1 = least["planet_1"]; s + 2 * p1 - off <= most; ++p1) {
            const double gap = kPi / static_cast<double>(n) -
                               std::asin(static_cast<double>(p1) / static_cast<double>(s + p1));
            if (gap < p["min_carrier_clearance_rad"].get<double>() - 1e-12) break;
            for (std::int64_t f = s + 2 * p1 - off; f <= std::min(most, s + 2 * p1 + off); ++f) {
              if ((s + f) % n != 0) continue;
              for (std::int64_t p2 = least["planet_2"]; p1 - p2 >= n; ++p2) {
                const double coaxial = static_cast<double>(s + p1) * m1 / m2;
                const auto from = static_cast<std::int64_t>(std::ceil(coaxial - 1e-9));
                const auto to = static_cast<std::int64_t>(std::floor(coaxial + 1e-9));
                for (std::int64_t o = p2 + to - off; o <= p2 + from + off; ++o) {
                  const std::int64_t turned = p1 * o - f * p2;
                  if (turned <= 0 || turned % (n * std::gcd(p1, p2)) != 0) continue;
                  if (std::abs(static_cast<double>(o - p2) - coaxial) >
                      static_cast<double>(off) + 1e-9) {
                    continue;
                  }
                  if (has_ratio(p, static_cast<double>((s + f) * p1 * o),
                                static_cast<double>(s * turned))) {
                    visit({s, p1, p2, f, o, n, m1, m2});
                  }
                }
              }
            }
          }
        }
      }
    }
  }
}

/// A whole number of modules and planets, and all sizes of the first layer that the bore holds.
using FirstLayer =
    std::function<void(std::int64_t n, double m1, double m2, std::int64_t s, std::int64_t p1)>;
void each_first_layer(const json& p, const FirstLayer& visit) {
  const json second = p["synthesis"].value("layer_2_module_mm", json());
  for (const std::int64_t n : list_of<std::int64_t>(p["planet_count"])) {
    for (const double m1 : list_of<double>(p["module_mm"])) {
      for (const double m2 : second.is_null() ? std::vector{m1} : list_of<double>(second)) {
        const std::int64_t most = most_in_bore(p, m1);
        for (std::int64_t s = p["min_teeth"]["sun"]; s <= most; ++s) {
          for (std::int64_t p1 = p["min_teeth"]["planet_1"]; p1 <= most; ++p1) {
            const double gap = kPi / static_cast<double>(n) -
                               std::asin(static_cast<double>(p1) / static_cast<double>(s + p1));
            if (gap < p["min_carrier_clearance_rad"].get<double>() - 1e-12) continue;
            visit(n, m1, m2, s, p1);
          }
        }
      }
    }
  }
}

/// Whether n planets with teeth p1 and p2 in the same place on all can stand equally spaced: some
/// turn of the planet at the first place puts its teeth into the spaces of both central gears.
/// `first`: teeth of a ring around p1, below zero of a sun inside.
bool stands_alike(std::int64_t n, std::int64_t first, std::int64_t p1, std::int64_t second,
                  std::int64_t p2) {
  // In parts of 1/(n p1 p2) of a turn: p1 x = -first/n and p2 x = -second/n modulo whole turns.
  for (std::int64_t k = 0; k < p1; ++k) {
    const std::int64_t x = (k * n - first) * p2;
    const std::int64_t rest = (x * p2 + second * p1 * p2) % (n * p1 * p2);
    if (rest == 0) return true;
  }
  return false;
}

void each_second_layer(const json& p, double between, std::int64_t m2_most,
                       const std::function<void(std::int64_t, std::int64_t)>& visit) {
  const auto off = p["synthesis"]["ring_teeth_off"].get<double>();
  for (std::int64_t p2 = p["min_teeth"]["planet_2"]; p2 <= m2_most; ++p2) {
    const auto from = static_cast<std::int64_t>(std::ceil(between - off - 1e-9));
    const auto to = static_cast<std::int64_t>(std::floor(between + off + 1e-9));
    for (std::int64_t ring = p2 + from; ring <= std::min(m2_most, p2 + to); ++ring) {
      visit(p2, ring);
    }
  }
}

void each_compound(const json& p, const std::function<void(const LoadedTeeth&)>& visit) {
  each_first_layer(p, [&](auto n, double m1, double m2, auto s, auto p1) {
    if (s + 2 * p1 > most_in_bore(p, m1)) return;
    const double between = static_cast<double>(s + p1) * m1 / m2;
    each_second_layer(p, between, most_in_bore(p, m2), [&](auto p2, auto ring) {
      const LoadedTeeth teeth{s, p1, p2, 0, ring, n, m1, m2};
      if (has_ratio(p, static_cast<double>(s * p2 + p1 * ring), static_cast<double>(s * p2)) &&
          stands_alike(n, -s, p1, ring, p2)) {
        visit(teeth);
      }
    });
  });
}

void each_three_k_b(const json& p, const std::function<void(const LoadedTeeth&)>& visit) {
  const std::int64_t off = p["synthesis"]["ring_teeth_off"];
  each_first_layer(p, [&](auto n, double m1, double m2, auto s, auto p1) {
    for (std::int64_t o = s + 2 * p1 - off; o <= s + 2 * p1 + off; ++o) {
      if (o > most_in_bore(p, m1) || (s + o) % n != 0) continue;
      const double between = static_cast<double>(s + p1) * m1 / m2;
      each_second_layer(p, between, most_in_bore(p, m2), [&](auto p2, auto f) {
        const LoadedTeeth teeth{s, p1, p2, o, f, n, m1, m2};
        const Motion motion = motion_of(teeth, "3k_b");
        if (motion.output() <= 1e-12 || !has_ratio(p, motion.sun, motion.output())) return;
        if (stands_alike(n, o, p1, f, p2)) visit(teeth);
      });
    }
  });
}

void each_train(const json& problem, const std::function<void(const LoadedTeeth&)>& visit) {
  const Given given(problem);
  const std::string topology = problem["topology"];
  const auto each = topology == "planetary"  ? each_single_stage
                    : topology == "compound" ? each_compound
                    : topology == "3k_b"     ? each_three_k_b
                                             : each_choice;
  each(problem, [&](const LoadedTeeth& teeth) {
    if (backlash(teeth, topology) <= given.number("max_backlash_rad_per_mm", kNone)) visit(teeth);
  });
}

}  // namespace

std::int64_t count_loaded_choices(const json& problem) {
  std::int64_t count = 0;
  each_train(problem, [&](const LoadedTeeth&) { ++count; });
  return count;
}

LoadedTrains enumerate_loaded_trains(const json& problem, int steps) {
  const Given given(problem);
  LoadedTrains found;
  each_train(problem, [&](const LoadedTeeth& teeth) {
    ++found.choices;
    const double best = found.lightest ? found.lightest->mass_kg : kNone;
    const auto train = Descent(given, teeth, steps).run(best);
    if (train && train->mass_kg < best) found.lightest = train;
  });
  return found;
}

}  // namespace torquewright::oracles
