// SPDX-License-Identifier: Apache-2.0
// The formulas that evaluate and strength use (teeth/, constraints/, strength/), once more for
// numbers and enclosures: geometry of docs/derivations/kinematics.md "Profile shift", stresses of
// docs/derivations/strength.md, roots of docs/derivations/tooth_outline.md.
#include <cmath>
#include <numbers>
#include <optional>
#include <type_traits>
#include <utility>

#include "gearbox/strength/strength.hpp"
#include "gearbox/synthesis/inner_case.hpp"
#include "gearbox/teeth/mesh.hpp"
#include "gearbox/teeth/tooth_form.hpp"
#include "gearbox/teeth/tooth_geometry.hpp"
#include "gearbox/train/efficiency.hpp"

namespace torquewright::gearbox {
namespace {

using std::abs;
using std::acos;
using std::atan;
using std::cos;
using std::exp;
using std::log;
using std::sin;
using std::sqrt;

constexpr double kPi = std::numbers::pi;
constexpr bool kExternal = false;
constexpr bool kInternal = true;

template <class T>
constexpr bool is_number = std::is_same_v<T, double>;

double lowest(double value) { return value; }
double lowest(const Slope& value) { return value.value.lower; }
double highest(double value) { return value; }
double highest(const Slope& value) { return value.value.upper; }

/// A gear as it is cut; the tip's diameter in modules.
template <class T>
struct Gear {
  double teeth;
  T shift;
  T tip;
  T tip_tangent;  ///< Of the pressure angle at the tip.

  double base_radius() const { return 0.5 * teeth * kReferenceCosine; }
};

template <class T>
Gear<T> gear(double teeth, const T& shift, const T& tip) {
  return {teeth, shift, tip, sqrt(square(tip / (teeth * kReferenceCosine)) - 1.0)};
}

/// Two gears at the centre distance.
template <class T>
struct Mesh {
  bool internal;
  Gear<T> first, second;
  double between;  ///< Teeth between the centres.
  T tangent;       ///< Of the working angle.
  ContactPath<T> path;
  T ratio;  ///< Contact ratio.
};

template <class T>
T working_tangent(const T& centre_mm, double module_mm, double between) {
  return sqrt(square(2.0 / (module_mm * between * kReferenceCosine) * centre_mm) - 1.0);
}

/// x_1 + x_2, or x_2 - x_1 in a ring, that closes the centre distance.
template <class T>
T closing_shift(const T& tangent, double between) {
  return between / (2.0 * kReferenceTangent) * (involute_of(tangent) - kReferenceInvolute);
}

template <class T>
Mesh<T> mesh(bool internal, const Gear<T>& first, const Gear<T>& second, const T& tangent) {
  const double sign = internal ? -1.0 : 1.0;
  ContactPath<T> path{sign * second.teeth / (2.0 * kPi) * (second.tip_tangent - tangent),
                      first.teeth / (2.0 * kPi) * (first.tip_tangent - tangent)};
  const T ratio = path.approach + path.recess;
  return {internal, first, second, second.teeth + sign * first.teeth, tangent, path, ratio};
}

/// Distance of the base circles' tangent points, in modules.
template <class T>
T tangent_distance(const Mesh<T>& mesh) {
  return 0.5 * mesh.between * kReferenceCosine * mesh.tangent;
}

/// From the base tangent point of an external gear to where its mate's tip touches it.
template <class T>
T lowest_contact(const Mesh<T>& mesh, bool of_second) {
  const Gear<T>& mate = of_second ? mesh.first : mesh.second;
  const T reach = mate.base_radius() * mate.tip_tangent;
  return mesh.internal ? reach - tangent_distance(mesh) : tangent_distance(mesh) - reach;
}

/// tooth_outline.md eq. (8).
template <class T>
T largest_hob_radius(const InnerCase& inner, const Gear<T>& gear, const T& lowest_contact) {
  const T depth =
      gear.shift + kReferenceSine * (0.5 * gear.teeth * kReferenceSine - lowest_contact);
  return (inner.hob_depth - depth) / (1.0 - kReferenceSine);
}

template <class T>
T assumed_radius(const std::optional<double>& stated, double assumed, const T& largest) {
  if (stated) return T(*stated);
  return max(min(largest, T(assumed)), T(0.0));
}

/// Y_F and Y_S as strength.hpp has them.
template <class T>
struct Factors {
  T form, concentration;
};

template <class T>
Factors<T> cantilever(const T& lever, const T& chord, const T& fillet, const T& load_rad) {
  const T slenderness = chord / lever;
  const T notch = 0.5 * chord / fillet;
  const T exponent = 1.0 / (1.21 + 2.3 / slenderness);
  return {6.0 / kReferenceCosine * lever * cos(load_rad) / square(chord),
          (1.2 + 0.13 * slenderness) * exp(exponent * log(notch))};
}

/// The section at 30 degrees of an external tooth.
template <class T>
struct RootSection {
  T offset, angle_rad, chord, fillet, radius;
};

template <class T>
RootSection<T> root_section(double teeth, const T& shift, double depth, const T& radius) {
  const T offset = radius - depth + shift;
  const T flank =
      kPi / 4.0 - depth * kReferenceTangent - (1.0 - kReferenceSine) / kReferenceCosine * radius;
  const T start = 2.0 / teeth * (kPi / 2.0 - flank) - kPi / 3.0;
  const T angle = root_angle_rad(2.0 / teeth * offset, start);
  const T cosine = cos(angle);
  const T chord = teeth * sin(kPi / 3.0 - angle) + std::numbers::sqrt3 * (offset / cosine - radius);
  const T fillet =
      radius + 2.0 * square(offset) / (cosine * (teeth * square(cosine) - 2.0 * offset));
  return {offset, angle, chord, fillet, radius};
}

/// With the load where the pressure angle has this tangent. The lever's d_e (cos(g) - sin(g)
/// tan(a)) is the base circle over cos(a).
template <class T>
Factors<T> factors_at(const Gear<T>& gear, const RootSection<T>& root, const T& tangent) {
  const T load_rad = tangent - kReferenceInvolute - kPi / 2.0 / gear.teeth -
                     2.0 * kReferenceTangent / gear.teeth * gear.shift;
  const T lever = 0.5 * (gear.teeth * kReferenceCosine / cos(load_rad) -
                         gear.teeth * cos(kPi / 3.0 - root.angle_rad) -
                         root.offset / cos(root.angle_rad) + root.radius);
  return cantilever(lever, root.chord, root.fillet, load_rad);
}

template <class T>
T root_limit_MPa(const InnerCase& inner, const T& concentration, double share) {
  const RootLimit& limit = inner.root;
  const T once = limit.static_MPa * (limit.notch_slope * concentration + limit.notch_constant);
  const double weight = limit.static_weight;
  if (weight >= 1.0) return once;
  const double endurance = limit.endurance_MPa * share;
  const T life = exp((1.0 - weight) * std::log(endurance) + weight * log(once));
  return min(once, life);
}

/// Width that a root asks for: its stress goes with 1/b.
template <class T>
T root_width_mm(const InnerCase& inner, double force_N, double module_mm, const T& stress_factor,
                const T& contact_ratio, const T& limit_MPa) {
  return force_N / module_mm * inner.root_factors * stress_factor * (0.25 + 0.75 / contact_ratio) /
         limit_MPa;
}

template <class T>
T external_root_mm(const InnerCase& inner, const Mesh<T>& mesh, bool second, const T& tip_radius,
                   const T& hob_radius, double force_N, double module_mm, double share) {
  const Gear<T>& gear = second ? mesh.second : mesh.first;
  const Factors<T> tip = factors_at(
      gear, root_section(gear.teeth, gear.shift, inner.hob_depth, tip_radius), gear.tip_tangent);
  const RootSection<T> root = root_section(gear.teeth, gear.shift, inner.hob_depth, hob_radius);
  const T overlap = min(mesh.ratio, T(2.0));
  const T outer = gear.tip_tangent - 2.0 * kPi / gear.teeth * (overlap - 1.0);
  const Factors<T> working = factors_at(gear, root, outer);
  return root_width_mm<T>(inner, force_N, module_mm, tip.form * tip.concentration, mesh.ratio,
                          root_limit_MPa(inner, working.concentration, share));
}

/// Half the angle of a ring's space at a radius of pressure angle with this tangent.
template <class T>
T half_space_rad(const Gear<T>& ring, const T& tangent) {
  return (kPi / 2.0 + 2.0 * kReferenceTangent * ring.shift) / ring.teeth + kReferenceInvolute -
         involute_of(tangent);
}

/// The shaper at its full depth, its rounding, and the section of the trochoid.
template <class T>
struct Shaper {
  double teeth, base;
  T tangent;  ///< Of the working angle of shaper and ring.
  T centre, tip;
  T largest_rounding;  ///< That leaves the planet its involute.
  T rounding;
  bool exists = false;      ///< Surely.
  bool is_pointed = false;  ///< Surely: then a rack's tooth stands for the ring's.
};

template <class T>
Shaper<T> shaper_of(const InnerCase& inner, const Mesh<T>& mesh) {
  const Gear<T>& planet = mesh.first;
  const Gear<T>& ring = mesh.second;
  Shaper<T> shaper;
  shaper.teeth = inner.shaper_teeth.value_or(planet.teeth);
  shaper.base = 0.5 * shaper.teeth * kReferenceCosine;
  const double between = ring.teeth - shaper.teeth;
  if (!(between > 0.0)) return shaper;
  const T involute = kReferenceInvolute + 2.0 * kReferenceTangent / between * ring.shift;
  if (!(lowest(involute) > 0.0)) return shaper;
  shaper.tangent = tangent_of_involute(involute);
  shaper.centre = 0.5 * between * kReferenceCosine * sqrt(1.0 + square(shaper.tangent));
  shaper.tip = 0.5 * ring.teeth + inner.shaper_depth + ring.shift - shaper.centre;
  const double half_land_rad = kPi / (2.0 * shaper.teeth) + kReferenceInvolute;
  const T tip_tangent = sqrt(square(shaper.tip / shaper.base) - 1.0);
  const T land_rad = half_land_rad - involute_of(tip_tangent);
  shaper.is_pointed = highest(land_rad) < 0.0;
  if (!(lowest(land_rad) >= 0.0)) return shaper;
  const T string = tangent_distance(mesh) + planet.base_radius() * planet.tip_tangent -
                   0.5 * between * kReferenceCosine * shaper.tangent;
  const T tip_string = shaper.base * tip_tangent;
  shaper.largest_rounding =
      0.5 * (tip_string - string) * (tip_string + string) / (shaper.tip - string);
  const T full = full_rounding(shaper.tip, shaper.base, half_land_rad, 1.1 * kRingFilletRadius);
  shaper.rounding = min(
      assumed_radius(inner.shaper_tip_radius, kRingFilletRadius, shaper.largest_rounding), full);
  shaper.exists = lowest(shaper.tip - shaper.rounding - shaper.base) > 0.0;
  return shaper;
}

/// What is the same for all sections of a ring's fillet.
template <class T>
struct Fillet {
  T arm, arm_angle_rad, pitch_point, end_rad, force_height, force_rad;
};

template <class T>
Fillet<T> fillet_of(const Mesh<T>& mesh, const Shaper<T>& shaper) {
  const Gear<T>& ring = mesh.second;
  const T arm = shaper.tip - shaper.rounding;
  const T profile_tangent = sqrt(square(arm / shaper.base) - 1.0);
  const T arm_angle = kPi / (2.0 * shaper.teeth) + kReferenceInvolute -
                      involute_of(profile_tangent) - shaper.rounding / shaper.base;
  const T end = atan(profile_tangent) - atan(shaper.tangent);
  const T half_tooth = kPi / ring.teeth - half_space_rad(ring, ring.tip_tangent);
  const T force_rad = atan(ring.tip_tangent) + half_tooth;
  const T sine = sin(force_rad), cosine = cos(force_rad);
  const T height = 0.5 * ring.tip * (cos(half_tooth) + sin(half_tooth) * sine / cosine);
  return {arm, arm_angle, ring.base_radius() * sqrt(1.0 + square(shaper.tangent)),
          end, height,    force_rad};
}

/// Y_F Y_S at a turn of the shaper, tooth_outline.md eqs. (15), (16), (22).
template <class T>
Factors<T> fillet_factors(const Mesh<T>& mesh, const Shaper<T>& shaper, const Fillet<T>& fillet,
                          double share) {
  const double k = shaper.teeth / mesh.second.teeth;
  const T turn = share * fillet.end_rad;
  const T arm_x = fillet.arm * cos(turn), arm_y = fillet.arm * sin(turn);
  const T x = shaper.centre + arm_x;
  const T from_pitch = x - fillet.pitch_point;
  const T reach = 1.0 + shaper.rounding / sqrt(square(from_pitch) + square(arm_y));
  const T cut_x = fillet.pitch_point + reach * from_pitch;
  const T cut_y = reach * arm_y;
  const T radius = sqrt(square(cut_x) + square(cut_y));
  const T angle = atan(cut_y / cut_x) - k * (turn - fillet.arm_angle_rad);
  const T half = kPi / mesh.second.teeth - angle;
  const T chord = 2.0 * radius * sin(half);
  const T lever = radius * cos(half) - fillet.force_height;
  const T ux = arm_x - k * x, uy = (1.0 - k) * arm_y;
  const T sx = (2.0 * k - 1.0) * arm_x - k * k * x;
  const T sy = (2.0 * k - 1.0 - k * k) * arm_y;
  const T speed_squared = square(ux) + square(uy);
  const T curvature =
      speed_squared * sqrt(speed_squared) / (-1.0 * (ux * sx + uy * sy)) + shaper.rounding;
  return cantilever(lever, chord, curvature, fillet.force_rad);
}

/// The share of the turn with the greatest stress: the vertex of a parabola through the greatest
/// of some sections and its neighbours. critical_ring_section() seeks it more closely; any section
/// bounds it from below.
double worst_share(const InnerCase& /*inner*/, const Mesh<double>& mesh,
                   const Shaper<double>& shaper) {
  const Fillet<double> fillet = fillet_of(mesh, shaper);
  constexpr int kSections = 8;
  std::array<double, kSections + 1> stress{};
  int best = 0;
  for (int i = 0; i <= kSections; ++i) {
    const Factors<double> factors = fillet_factors(mesh, shaper, fillet, i / double{kSections});
    stress[i] = factors.form * factors.concentration;
    if (stress[i] > stress[best]) best = i;
  }
  if (best == 0 || best == kSections) return best / double{kSections};
  const double before = stress[best] - stress[best - 1];
  const double after = stress[best] - stress[best + 1];
  return (best + 0.5 * (before - after) / (before + after)) / double{kSections};
}

double amid(const Slope& value) { return value.center.middle(); }

Gear<double> amid(const Gear<Slope>& gear) {
  return {gear.teeth, amid(gear.shift), amid(gear.tip), amid(gear.tip_tangent)};
}

/// The same amid a box.
double worst_share(const InnerCase& inner, const Mesh<Slope>& wide, const Shaper<Slope>& /*tool*/) {
  const Mesh<double> middle =
      mesh(wide.internal, amid(wide.first), amid(wide.second), amid(wide.tangent));
  const Shaper<double> shaper = shaper_of(inner, middle);
  if (!shaper.exists) return 0.5;
  const double share = worst_share(inner, middle, shaper);
  return share >= 0.0 && share <= 1.0 ? share : 0.5;
}

/// Width that a ring's root asks for; nothing where no bound is known.
template <class T>
std::optional<T> ring_root_mm(const InnerCase& inner, const Mesh<T>& mesh, const Shaper<T>& shaper,
                              double force_N, double module_mm) {
  Factors<T> factors;
  if (shaper.exists) {
    const double place = worst_share(inner, mesh, shaper);
    factors = fillet_factors(mesh, shaper, fillet_of(mesh, shaper), place);
  } else if (is_number<T> || shaper.is_pointed) {
    // The ring's tooth is as high as its shaper's addendum and its own, whatever its shift.
    const double radius = inner.shaper_tip_radius.value_or(kRingFilletRadius);
    const RootFactors rack =
        din3990_ring_root_factors(inner.shaper_depth + 1.0, {inner.shaper_depth, radius});
    factors = {T(rack.form), T(rack.concentration)};
  } else {
    return std::nullopt;
  }
  return root_width_mm<T>(inner, force_N, module_mm, factors.form * factors.concentration,
                          mesh.ratio, root_limit_MPa(inner, factors.concentration, 1.0));
}

/// Width that the flanks of a mesh ask for, the inner point of single contact of gear 1 (second:
/// of gear 2) counted.
template <class T>
T flank_width_mm(const InnerCase& inner, const Mesh<T>& mesh, bool second, double force_N,
                 double module_mm) {
  const Gear<T>& first = second ? mesh.second : mesh.first;
  const Gear<T>& mate = second ? mesh.first : mesh.second;
  const double sign = mesh.internal ? -1.0 : 1.0;
  const T inner_1 = first.tip_tangent - 2.0 * kPi / first.teeth;
  const T inner_2 = mate.tip_tangent - sign * 2.0 * kPi / mate.teeth * (mesh.ratio - 1.0);
  const T at_inner_point = max(square(mesh.tangent) / (inner_1 * inner_2), T(1.0));
  const double ratio_term = 1.0 + sign * mesh.first.teeth / mesh.second.teeth;
  const double constant = square(inner.elasticity) * 2.0 / square(kReferenceCosine) * force_N /
                          (mesh.first.teeth * module_mm) * ratio_term * inner.flank_factors /
                          square(inner.flank_limit_MPa);
  return constant / mesh.tangent * (max(4.0 - mesh.ratio, T(0.0)) / 3.0) * at_inner_point;
}

template <class T>
T tip_thickness(const Gear<T>& gear, bool internal) {
  const T shape_rad = half_space_rad(gear, gear.tip_tangent);
  return internal ? gear.tip * (kPi / gear.teeth - shape_rad) : gear.tip * shape_rad;
}

template <class T>
T trochoid_margin(const Mesh<T>& mesh) {
  const T r1 = 0.5 * mesh.first.tip, r2 = 0.5 * mesh.second.tip;
  const T centre = 0.5 * mesh.between * kReferenceCosine * sqrt(1.0 + square(mesh.tangent));
  const T squares = square(r2) - square(r1);
  const T at_planet = acos((squares - square(centre)) / (2.0 * centre * r1));
  const T at_ring = acos((squares + square(centre)) / (2.0 * centre * r2));
  const T working = involute_of(mesh.tangent);
  return (at_planet + involute_of(mesh.first.tip_tangent) - working) *
             (mesh.first.teeth / mesh.second.teeth) +
         working - involute_of(mesh.second.tip_tangent) - at_ring;
}

/// Gathers margins with their names (asked for without a point) and widths, until one of them
/// leaves nothing that is of interest.
template <class T>
class Gathered {
 public:
  Gathered(LayerValues<T>& values, double widest_mm, double cutoff_kg,
           std::vector<std::string>* names)
      : values_(values), widest_mm_(widest_mm), cutoff_kg_(cutoff_kg), names_(names) {}

  void add(const char* name, const T& margin) {
    values_.margins.push_back(margin);
    if (names_ != nullptr) names_->emplace_back(name);
    if (!is_number<T> && highest(margin) < -kMarginSlack) is_over_ = true;
  }
  /// Requires the mass per width.
  void add_width(const T& width_mm) {
    values_.width_mm.push_back(width_mm);
    if (is_number<T>) return;
    is_over_ = is_over_ || lowest(width_mm) > widest_mm_ + kMarginSlack ||
               lowest(width_mm) * lowest(values_.mass_per_width_kg_mm) > cutoff_kg_;
  }
  bool is_over() const { return is_over_; }

 private:
  LayerValues<T>& values_;
  double widest_mm_;
  double cutoff_kg_;
  std::vector<std::string>* names_;
  bool is_over_ = false;
};

/// A root's width. The stress with the load at the tip falls with the tool's rounding (a test holds
/// it on a grid), so that over a box the largest rounding bounds it from below, which keeps wide
/// boxes useful; the limit is enclosed for every rounding. A rounding that is known well enough
/// stands besides as it is.
template <class T>
void add_root_width(Gathered<T>& gathered, const InnerCase& inner, const Mesh<T>& mesh, bool second,
                    const T& hob_radius, double force_N, double module_mm, double share) {
  if constexpr (is_number<T>) {
    gathered.add_width(
        external_root_mm(inner, mesh, second, hob_radius, hob_radius, force_N, module_mm, share));
  } else {
    constexpr double kWellKnown = 0.05;
    const double largest = hob_radius.value.upper;
    const bool falls = (second ? mesh.second : mesh.first).shift.value.upper <= kGreatestRuledShift;
    if (falls) {
      gathered.add_width(
          external_root_mm(inner, mesh, second, T(largest), hob_radius, force_N, module_mm, share));
    }
    if (falls && largest - hob_radius.value.lower > kWellKnown) return;
    gathered.add_width(
        external_root_mm(inner, mesh, second, hob_radius, hob_radius, force_N, module_mm, share));
  }
}

/// strength.md eq. (16).
template <class T>
T mesh_softness(const InnerCase& inner, std::size_t which, const Mesh<T>& mesh) {
  return inner.mesh_softness[which] / (0.75 * mesh.ratio + 0.25);
}

/// The layer is as wide as if it alone were soft, at least.
template <class T>
void add_stiffness(const InnerCase& inner, Gathered<T>& gathered, LayerValues<T>& result,
                   const T& softness) {
  if (!inner.most_softness_rad_Nm) return;
  result.softness_rad_mm_Nm = softness;
  gathered.add_width(softness / *inner.most_softness_rad_Nm);
}

/// One layer's planet in its ring.
template <class T>
struct RingLayer {
  Mesh<T> mesh;
  Shaper<T> shaper;
  T hob_largest;
};

template <class T>
RingLayer<T> ring_layer(const InnerCase& inner, const T& centre_mm, double module_mm,
                        const Gear<T>& planet, double ring_teeth) {
  const double between = ring_teeth - planet.teeth;
  const T tangent = working_tangent(centre_mm, module_mm, between);
  const T shift = planet.shift + closing_shift(tangent, between);
  const Gear<T> ring = gear<T>(ring_teeth, shift, ring_teeth - 2.0 * (1.0 - shift));
  RingLayer<T> layer{mesh(kInternal, planet, ring, tangent), {}, {}};
  layer.hob_largest = largest_hob_radius(inner, planet, lowest_contact(layer.mesh, false));
  return layer;
}

/// Of a planet of a layer, whatever it meshes with.
template <class T>
void add_planet_margins(const InnerCase& inner, const Gear<T>& planet, const T& centre_mm,
                        std::size_t which, Gathered<T>& margins) {
  margins.add("neighbour_clearance", 2.0 * inner.sine_of_half_spacing * centre_mm -
                                         inner.module_mm[which] * planet.tip -
                                         inner.min_neighbour_clearance_mm);
  margins.add("undercut.planet",
              planet.shift - inner.undercut_depth * (1.0 - planet.teeth * square(kReferenceSine) /
                                                               (2.0 * inner.undercut_depth)));
}

/// The cheap ones.
template <class T>
void add_ring_margins(const InnerCase& inner, const RingLayer<T>& layer, const T& centre_mm,
                      std::size_t which, Gathered<T>& margins) {
  const Mesh<T>& mesh = layer.mesh;
  const Gear<T>& planet = mesh.first;
  const Gear<T>& ring = mesh.second;
  const double m = inner.module_mm[which];
  add_planet_margins(inner, planet, centre_mm, which, margins);
  const T ring_root = ring.teeth + 2.0 * ring.shift + 2.0 * inner.shaper_depth;
  margins.add("ring_wall", inner.ring_space_mm - 2.0 * inner.wall_mm[which] - m * ring_root);
  margins.add("ring_tip", ring.tip - ring.teeth * kReferenceCosine);
  margins.add("interference.involute", lowest_contact(mesh, false));
  margins.add("contact_ratio", mesh.ratio - std::max(1.0, inner.min_contact_ratio));
  const T planet_root = 0.5 * planet.teeth + planet.shift - inner.hob_depth;
  margins.add("bottom_clearance.planet", 0.5 * m * ring.tip - centre_mm - m * planet_root);
  margins.add("bottom_clearance.ring", 0.5 * m * ring_root - centre_mm - 0.5 * m * planet.tip);
  margins.add("root_form.hob", layer.hob_largest - inner.hob_tip_radius.value_or(0.0));
}

/// Of a planet that no ring is around.
template <class T>
void add_ringless_margins(const InnerCase& inner, const Gear<T>& planet, const T& centre_mm,
                          Gathered<T>& margins) {
  add_planet_margins(inner, planet, centre_mm, 0, margins);
  margins.add("planet_room",
              inner.ring_space_mm - 2.0 * centre_mm - inner.module_mm[0] * planet.tip);
  margins.add("tip_thickness.planet", tip_thickness(planet, kExternal) - inner.min_tip_thickness);
}

template <class T>
void add_dear_ring_margins(const InnerCase& inner, RingLayer<T>& layer, Gathered<T>& margins) {
  const Mesh<T>& mesh = layer.mesh;
  margins.add("tip_thickness.planet",
              tip_thickness(mesh.first, kExternal) - inner.min_tip_thickness);
  margins.add("tip_thickness.ring",
              tip_thickness(mesh.second, kInternal) - inner.min_tip_thickness);
  margins.add("interference.trochoid", trochoid_margin(mesh));
  layer.shaper = shaper_of(inner, mesh);
  margins.add("root_form.shaper", layer.shaper.exists ? T(layer.shaper.largest_rounding -
                                                          inner.shaper_tip_radius.value_or(0.0))
                                                      : T(1.0));
}

template <class T>
void add_sun_margins(const InnerCase& inner, const Mesh<T>& mesh, const T& centre_mm,
                     const std::array<T, 2>& hob_largest, Gathered<T>& margins) {
  const Gear<T>& sun = mesh.first;
  const Gear<T>& planet = mesh.second;
  const double m = inner.module_mm[0];
  const double stated = inner.hob_tip_radius.value_or(0.0);
  margins.add("undercut.sun",
              sun.shift - inner.undercut_depth * (1.0 - sun.teeth * square(kReferenceSine) /
                                                            (2.0 * inner.undercut_depth)));
  margins.add("profile_shift.sun", sun.shift - inner.least_shift);
  margins.add("profile_shift.sun", inner.greatest_shift - sun.shift);
  margins.add("contact_ratio.sun", mesh.ratio - std::max(1.0, inner.min_contact_ratio));
  margins.add("lowest_contact.sun", lowest_contact(mesh, false));
  margins.add("lowest_contact.planet_1", lowest_contact(mesh, true));
  margins.add("tip_thickness.sun", tip_thickness(sun, kExternal) - inner.min_tip_thickness);
  margins.add("root_form.hob.sun", hob_largest[0] - stated);
  margins.add("root_form.hob.planet_1", hob_largest[1] - stated);
  const T sun_root = 0.5 * sun.teeth + sun.shift - inner.hob_depth;
  const T planet_root = 0.5 * planet.teeth + planet.shift - inner.hob_depth;
  margins.add("bottom_clearance.sun", centre_mm - 0.5 * m * planet.tip - m * sun_root);
  margins.add("bottom_clearance.planet_1", centre_mm - 0.5 * m * sun.tip - m * planet_root);
  if (inner.min_hollow_shaft_mm) {
    margins.add("hollow_shaft",
                2.0 * m * sun_root - 2.0 * inner.hollow_shaft_wall_mm - *inner.min_hollow_shaft_mm);
  }
}

template <class T>
T mesh_efficiency(const InnerCase& inner, const Mesh<T>& mesh) {
  const bool is_asked =
      is_number<T> || inner.min_forward_efficiency || inner.min_backward_efficiency;
  if (!inner.friction || !is_asked) return T(1.0);
  const double sign = mesh.internal ? -1.0 : 1.0;
  const double curvature = 1.0 / mesh.first.teeth + sign / mesh.second.teeth;
  return 1.0 - *inner.friction * kPi * curvature * sliding_loss_factor(mesh.path);
}

/// Mass of a millimetre of width, as train/mass.hpp counts it.
template <class T>
T ring_share(const InnerCase& inner, const Gear<T>& ring, std::size_t layer) {
  const double m = inner.module_mm[layer] * 1e-3;
  const double rim = 2.0 * inner.shaper_depth * m + 2.0 * inner.wall_mm[layer] * 1e-3;
  return rim * (2.0 * m * (ring.teeth + 2.0 * ring.shift) + rim);
}

template <class T>
T disc_share(const InnerCase& inner, const Gear<T>& planet, std::size_t layer) {
  const double m = inner.module_mm[layer] * 1e-3;
  return inner.planets * square(m * (planet.teeth + 2.0 * planet.shift));
}

template <class T>
T sun_share(const InnerCase& inner, const Gear<T>& sun) {
  const double m = inner.module_mm[0] * 1e-3;
  const double rim = 2.0 * inner.hob_depth * m + 2.0 * inner.wall_mm[0] * 1e-3;
  const T size = m * (sun.teeth + 2.0 * sun.shift);
  // The annulus k (2 d - k), or a disc where the bore would vanish.
  return rim * (2.0 * size - rim) + square(min(size - rim, T(0.0)));
}

bool is_inertia_asked(const InnerCase& inner) { return inner.max_gear_inertia_kg_m2.has_value(); }

/// Inertia at the output of a millimetre of width over its mass' constant, as train/inertia.hpp
/// counts it: planets run with the carrier and spin.
template <class T>
T planets_inertia_share(const InnerCase& inner, const T& centre_mm, const Gear<T>& planet,
                        std::size_t layer) {
  const double m = inner.module_mm[layer] * 1e-3;
  const T size_squared = square(m * (planet.teeth + 2.0 * planet.shift));
  const T arm_squared = square(1e-3 * inner.carrier_speed_per_sun * centre_mm);
  return square(inner.ratio) * inner.planets * size_squared *
         (arm_squared + square(inner.planet_speed_per_sun) / 8.0 * size_squared);
}

template <class T>
T sun_inertia_share(const InnerCase& inner, const Gear<T>& sun) {
  const double m = inner.module_mm[0] * 1e-3;
  const double rim = 2.0 * inner.hob_depth * m + 2.0 * inner.wall_mm[0] * 1e-3;
  const T size = m * (sun.teeth + 2.0 * sun.shift);
  const T bore = max(size - rim, T(0.0));
  return square(inner.ratio) / 8.0 * sun_share(inner, sun) * (square(size) + square(bore));
}

/// Of a ring: that which is the output turns with it.
template <class T>
T ring_inertia_share(const InnerCase& inner, const Gear<T>& ring, std::size_t layer) {
  if (inner.output_layer != layer) return T(0.0);
  const double m = inner.module_mm[layer] * 1e-3;
  const double rim = 2.0 * inner.shaper_depth * m + 2.0 * inner.wall_mm[layer] * 1e-3;
  const T size = m * (ring.teeth + 2.0 * ring.shift);
  return 0.125 * ring_share(inner, ring, layer) * (square(size) + square(size + rim));
}

/// Sun and planet 1 as they are cut at a centre distance, and their mesh.
template <class T>
Mesh<T> sun_mesh_at(const InnerCase& inner, const T& centre_mm, const T& shift_1) {
  const double m1 = inner.module_mm[0];
  const double between = inner.teeth[0] + inner.teeth[1];
  const T tangent = working_tangent(centre_mm, m1, between);
  const T shifts = closing_shift(tangent, between);
  const T increment = (1.0 / m1) * centre_mm - 0.5 * between;  // y
  const T shortening = min(increment - shifts, T(0.0));
  const Gear<T> sun =
      gear<T>(inner.teeth[0], shifts - shift_1, inner.teeth[0] + 2.0 * (1.0 + increment - shift_1));
  const Gear<T> planet_1 =
      gear<T>(inner.teeth[1], shift_1, inner.teeth[1] + 2.0 * (1.0 + shift_1 + shortening));
  return mesh(kExternal, sun, planet_1, tangent);
}

/// Mass and inertia of a millimetre of the first layer.
template <class T>
void set_first_masses(const InnerCase& inner, const T& centre_mm, const Mesh<T>& sun_mesh,
                      const std::optional<RingLayer<T>>& ring, LayerValues<T>& result) {
  const Gear<T>& sun = sun_mesh.first;
  const Gear<T>& planet_1 = sun_mesh.second;
  const double areal_kg = inner.density_kg_m3 * kPi / 4.0 * 1e-3;
  const T of_ring = ring ? ring_share(inner, ring->mesh.second, 0) : T(0.0);
  result.mass_per_width_kg_mm =
      areal_kg * (disc_share(inner, planet_1, 0) + of_ring + sun_share(inner, sun));
  if (!is_inertia_asked(inner)) {
    result.inertia_per_width_kg_m2_mm = T(0.0);
    return;
  }
  const T turning = ring ? ring_inertia_share(inner, ring->mesh.second, 0) : T(0.0);
  result.inertia_per_width_kg_m2_mm =
      areal_kg * (sun_inertia_share(inner, sun) +
                  planets_inertia_share(inner, centre_mm, planet_1, 0) + turning);
}

/// The layer of the sun, planet 1 and, but in a compound train, a ring.
template <class T>
LayerValues<T> first_layer(const InnerCase& inner, const T& centre_mm, const T& shift_1,
                           double cutoff_kg, std::vector<std::string>* names) {
  LayerValues<T> result;
  Gathered<T> gathered(result, inner.max_face_width_mm[0], cutoff_kg, names);
  const double m1 = inner.module_mm[0];
  const Mesh<T> sun_mesh = sun_mesh_at(inner, centre_mm, shift_1);
  const Gear<T>& planet_1 = sun_mesh.second;
  std::optional<RingLayer<T>> ring;
  if (inner.has_first_ring) ring = ring_layer(inner, centre_mm, m1, planet_1, inner.teeth[3]);
  const std::array<T, 2> hob_largest{
      largest_hob_radius(inner, sun_mesh.first, lowest_contact(sun_mesh, false)),
      largest_hob_radius(inner, planet_1, lowest_contact(sun_mesh, true))};
  set_first_masses(inner, centre_mm, sun_mesh, ring, result);
  if (ring) {
    add_ring_margins(inner, *ring, centre_mm, 0, gathered);
  } else {
    add_ringless_margins(inner, planet_1, centre_mm, gathered);
  }
  if (gathered.is_over()) return result;
  add_sun_margins(inner, sun_mesh, centre_mm, hob_largest, gathered);
  if (gathered.is_over()) return result;
  result.efficiency = {mesh_efficiency(inner, sun_mesh),
                       ring ? mesh_efficiency(inner, ring->mesh) : T(1.0)};

  const auto& force = inner.reference_force_N;
  gathered.add_width(T(inner.min_face_width_mm));
  if (ring) gathered.add_width(flank_width_mm(inner, ring->mesh, false, force[1], m1));
  gathered.add_width(flank_width_mm(inner, sun_mesh, false, force[0], m1));
  gathered.add_width(flank_width_mm(inner, sun_mesh, true, force[0], m1));
  const T of_sun = mesh_softness(inner, 0, sun_mesh);
  add_stiffness(inner, gathered, result,
                ring ? T(of_sun + mesh_softness(inner, 1, ring->mesh)) : of_sun);
  if (gathered.is_over()) return result;
  const T hob_1 =
      assumed_radius<T>(inner.hob_tip_radius, kHobTipRadius,
                        ring ? T(min(hob_largest[1], ring->hob_largest)) : hob_largest[1]);
  const double alternating = inner.alternating_bending;
  if (ring) {
    add_root_width<T>(gathered, inner, ring->mesh, false, hob_1, force[1], m1, alternating);
    if (gathered.is_over()) return result;
    add_dear_ring_margins(inner, *ring, gathered);
    if (gathered.is_over()) return result;
  }
  add_root_width<T>(gathered, inner, sun_mesh, true, hob_1, force[0], m1, alternating);
  const T hob_sun = assumed_radius(inner.hob_tip_radius, kHobTipRadius, hob_largest[0]);
  add_root_width<T>(gathered, inner, sun_mesh, false, hob_sun, force[0], m1, 1.0);
  if (gathered.is_over() || !ring) return result;
  if (auto width = ring_root_mm(inner, ring->mesh, ring->shaper, force[1], m1)) {
    gathered.add_width(*width);
  }
  return result;
}

template <class T>
LayerValues<T> no_layer() {
  LayerValues<T> nothing;
  nothing.width_mm = {T(0.0)};
  nothing.mass_per_width_kg_mm = nothing.inertia_per_width_kg_m2_mm = T(0.0);
  nothing.efficiency = {T(1.0), T(1.0)};
  return nothing;
}

/// The layer of planet 2 and its ring.
template <class T>
LayerValues<T> second_layer(const InnerCase& inner, const T& centre_mm, const T& shift_2,
                            double cutoff_kg, std::vector<std::string>* names) {
  LayerValues<T> result;
  if (!inner.has_second_layer) return no_layer<T>();
  Gathered<T> gathered(result, inner.max_face_width_mm[1], cutoff_kg, names);
  const double m2 = inner.module_mm[1];
  const Gear<T> planet_2 = gear<T>(inner.teeth[2], shift_2, inner.teeth[2] + 2.0 * (1.0 + shift_2));
  RingLayer<T> ring = ring_layer(inner, centre_mm, m2, planet_2, inner.teeth[4]);
  const double areal_kg = inner.density_kg_m3 * kPi / 4.0 * 1e-3;
  result.mass_per_width_kg_mm =
      areal_kg * (disc_share(inner, planet_2, 1) + ring_share(inner, ring.mesh.second, 1));
  result.inertia_per_width_kg_m2_mm =
      is_inertia_asked(inner) ? areal_kg * (ring_inertia_share(inner, ring.mesh.second, 1) +
                                            planets_inertia_share(inner, centre_mm, planet_2, 1))
                              : T(0.0);
  add_ring_margins(inner, ring, centre_mm, 1, gathered);
  if (gathered.is_over()) return result;
  result.efficiency = {mesh_efficiency(inner, ring.mesh), T(1.0)};

  const double force_N = inner.reference_force_N[2];
  gathered.add_width(T(inner.min_face_width_mm));
  gathered.add_width(flank_width_mm(inner, ring.mesh, false, force_N, m2));
  add_stiffness(inner, gathered, result, mesh_softness(inner, 2, ring.mesh));
  if (gathered.is_over()) return result;
  const T hob_2 = assumed_radius(inner.hob_tip_radius, kHobTipRadius, ring.hob_largest);
  add_root_width<T>(gathered, inner, ring.mesh, false, hob_2, force_N, m2, 1.0);
  if (gathered.is_over()) return result;
  add_dear_ring_margins(inner, ring, gathered);
  if (gathered.is_over()) return result;
  if (auto width = ring_root_mm(inner, ring.mesh, ring.shaper, force_N, m2)) {
    gathered.add_width(*width);
  }
  return result;
}

template <class T>
LayerValues<T> values(const InnerCase& inner, std::size_t layer, const T& centre_mm, const T& shift,
                      double cutoff_kg, std::vector<std::string>* names) {
  return layer == 0 ? first_layer(inner, centre_mm, shift, cutoff_kg, names)
                    : second_layer(inner, centre_mm, shift, cutoff_kg, names);
}

}  // namespace

LayerValues<double> layer_values(const InnerCase& inner, std::size_t layer, double centre_mm,
                                 double shift) {
  return values<double>(inner, layer, centre_mm, shift, 0.0, nullptr);
}

LayerValues<Slope> layer_values(const InnerCase& inner, std::size_t layer, const InnerPlace& box,
                                double cutoff_kg) {
  return values<Slope>(inner, layer, box.variable(0), box.variable(1), cutoff_kg, nullptr);
}

std::vector<std::string> margin_names(const InnerCase& inner, std::size_t layer) {
  std::vector<std::string> names;
  const double centre_mm = 0.5 * inner.module_mm[0] * (inner.teeth[0] + inner.teeth[1]);
  values<double>(inner, layer, centre_mm, 0.0, 0.0, &names);
  return names;
}

double sun_clearance_mm(const InnerCase& inner, double shift_1, double shift_2) {
  return inner.module_mm[0] * (0.5 * inner.teeth[1] - 1.0 + shift_1) -
         inner.module_mm[1] * (0.5 * inner.teeth[2] + 1.0 + shift_2);
}

std::array<double, 2> train_efficiencies(const InnerCase& inner, double sun, double first_ring,
                                         double second_ring) {
  const std::array<double, 2> rings{first_ring, second_ring};
  const ThreeKMeshEfficiencies<double> mesh{sun, rings[inner.held_layer],
                                            inner.output_layer ? rings[*inner.output_layer] : 1.0};
  const auto& [ratio_1, ratio_2] = inner.basic_ratio;
  return {three_k_forward_efficiency(ratio_1, ratio_2, mesh),
          three_k_backward_efficiency(ratio_1, ratio_2, mesh)};
}

}  // namespace torquewright::gearbox
