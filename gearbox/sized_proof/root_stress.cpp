// SPDX-License-Identifier: Apache-2.0
#include "gearbox/sized_proof/root_stress.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "gearbox/strength/strength.hpp"
#include "gearbox/teeth/tooth_form.hpp"

namespace torquewright::gearbox::sized {
namespace {

double lowest(double value) { return value; }
double lowest(const Affine& value) { return value.is_nowhere() ? -kInfinity : value.low; }
double highest(double value) { return value; }
double highest(const Affine& value) { return value.is_nowhere() ? kInfinity : value.high; }

/// strength.md: a beam with a notch.
template <class T>
NotchFactors<T> bent_beam(const T& lever, const T& chord, const T& fillet, const T& force_rad) {
  const T slenderness = chord / lever;
  const T exponent = 1.0 / (1.21 + 2.3 / slenderness);
  return {(6.0 / kReferenceCosine) * lever * cosine(force_rad) / squared(chord),
          (1.2 + 0.13 * slenderness) * exponential(exponent * logarithm(0.5 * chord / fillet))};
}

/// Where a tangent at 30 degrees touches the root of an external tooth.
template <class T>
struct ThirtyDegrees {
  T offset, angle_rad, chord, fillet, radius;
};

template <class T>
ThirtyDegrees<T> thirty_degrees(const CutGear<T>& gear, double depth, const T& radius) {
  const double z = gear.teeth;
  const T offset = radius + gear.shift - depth;  // G
  const T edge = (kPi / 4.0 - depth * kReferenceTangent) -
                 ((1.0 - kReferenceSine) / kReferenceCosine) * radius;  // E
  const T start = (2.0 / z) * (kPi / 2.0 - edge) - kPi / 3.0;           // H
  const T angle = section_angle_rad(T((2.0 / z) * offset), start);
  const T c = cosine(angle);
  return {offset, angle,
          z * sine(T(kPi / 3.0 - angle)) + std::numbers::sqrt3 * (offset / c - radius),
          radius + 2.0 * squared(offset) / (c * (z * squared(c) - 2.0 * offset)), radius};
}

/// With the load on the flank where the pressure angle has this tangent.
template <class T>
NotchFactors<T> loaded_at(const CutGear<T>& gear, const ThirtyDegrees<T>& section,
                          const T& tangent) {
  const double z = gear.teeth;
  const T force_rad =
      tangent - (2.0 * kReferenceTangent / z) * gear.shift - (kReferenceInvolute + kPi / 2.0 / z);
  const T lever = 0.5 * ((z * kReferenceCosine) / cosine(force_rad) -
                         z * cosine(T(kPi / 3.0 - section.angle_rad)) -
                         section.offset / cosine(section.angle_rad) + section.radius);
  return bent_beam(lever, section.chord, section.fillet, force_rad);
}

/// For the problem's loads, of a root that concentrates the stress so much.
template <class T>
T root_limit_MPa(const RootStrength& root, const T& concentration, double alternating) {
  const T once = root.static_slope_MPa * concentration + root.static_constant_MPa;
  if (root.static_share >= 1.0) return once;
  const double endurance = std::log(root.endurance_MPa * alternating);
  const T often =
      exponential(T(root.static_share * logarithm(once) + (1.0 - root.static_share) * endurance));
  return least(once, often);
}

template <class T>
T root_mm(const LoadedTeeth& teeth, const MeshLoad& load, const T& stress_factor,
          const T& contact_ratio, const T& limit_MPa) {
  return (load.force_N / load.module_mm * teeth.root_factors) * stress_factor *
         (0.25 + 0.75 / contact_ratio) / limit_MPa;
}

/// What all places of a ring's root share. tooth_outline.md eq. (14)...(16).
template <class T>
struct Trochoid {
  T arm, arm_angle_rad, pitch_point, end_rad, force_height, force_rad;
};

template <class T>
Trochoid<T> trochoid(const GearMesh<T>& mesh, const RingShaper<T>& shaper) {
  const CutGear<T>& ring = mesh.second;
  Trochoid<T> path;
  path.arm = shaper.tip - shaper.rounding;
  const T tangent = root(squared((1.0 / shaper.base) * path.arm) - 1.0);
  path.arm_angle_rad = (kPi / (2.0 * shaper.teeth) + kReferenceInvolute) - involute(tangent) -
                       (1.0 / shaper.base) * shaper.rounding;
  path.pitch_point = ring.base() * root(squared(shaper.tangent) + 1.0);
  path.end_rad = arc_tangent(tangent) - arc_tangent(shaper.tangent);
  const T half_tooth = kPi / ring.teeth - half_angle_rad(ring, ring.tangent);
  path.force_rad = arc_tangent(ring.tangent) + half_tooth;
  path.force_height =
      0.5 * ring.tip *
      (cosine(half_tooth) + sine(half_tooth) * sine(path.force_rad) / cosine(path.force_rad));
  return path;
}

template <class T>
NotchFactors<T> at_place(const GearMesh<T>& mesh, const RingShaper<T>& shaper,
                         const Trochoid<T>& path, double place) {
  const double z = mesh.second.teeth, k = shaper.teeth / z;
  const T turn = place * path.end_rad;
  const T arm_x = path.arm * cosine(turn), arm_y = path.arm * sine(turn);
  const T from_pitch_x = shaper.centre + arm_x - path.pitch_point;
  const T stretch = 1.0 + shaper.rounding / root(squared(from_pitch_x) + squared(arm_y));
  const T x = path.pitch_point + stretch * from_pitch_x, y = stretch * arm_y;
  const T radius = root(squared(x) + squared(y));
  const T half = kPi / z - arc_tangent(T(y / x)) + k * (turn - path.arm_angle_rad);
  // Eq. (22), K' and K'' turned back.
  const T ux = (1.0 - k) * arm_x - k * shaper.centre, uy = (1.0 - k) * arm_y;
  const double bend = (1.0 - k) * (1.0 - k);
  const T sx = bend * arm_x + (k * k) * shaper.centre, sy = bend * arm_y;
  const T speed_squared = squared(ux) + squared(uy);
  const T fillet = speed_squared * root(speed_squared) / (ux * sx + uy * sy) + shaper.rounding;
  return bent_beam(T(radius * cosine(half) - path.force_height), T(2.0 * radius * sine(half)),
                   fillet, path.force_rad);
}

}  // namespace

template <class T>
T external_root_mm(const LoadedTeeth& teeth, const GearMesh<T>& mesh, bool of_second,
                   const T& stress_radius, const T& limit_radius, const MeshLoad& load,
                   double alternating) {
  const CutGear<T>& gear = of_second ? mesh.second : mesh.first;
  const NotchFactors<T> at_tip =
      loaded_at(gear, thirty_degrees(gear, teeth.hob_depth, stress_radius), gear.tangent);
  const T below_tip = (2.0 * kPi / gear.teeth) * (least(mesh.contact_ratio, T(2.0)) - 1.0);
  const NotchFactors<T> working = loaded_at(
      gear, thirty_degrees(gear, teeth.hob_depth, limit_radius), T(gear.tangent - below_tip));
  return root_mm(teeth, load, T(at_tip.form * at_tip.stress), mesh.contact_ratio,
                 root_limit_MPa(teeth.root, working.stress, alternating));
}

template <class T>
T flank_mm(const LoadedTeeth& teeth, const GearMesh<T>& mesh, bool of_second,
           const MeshLoad& load) {
  const CutGear<T>& own = of_second ? mesh.second : mesh.first;
  const CutGear<T>& mate = of_second ? mesh.first : mesh.second;
  const double sign = mesh.is_inside ? -1.0 : 1.0;
  const T inner = own.tangent - 2.0 * kPi / own.teeth;
  const T of_mate = mate.tangent - (sign * 2.0 * kPi / mate.teeth) * (mesh.contact_ratio - 1.0);
  const double z1 = mesh.first.teeth, z2 = mesh.second.teeth;
  const double constant = 2.0 * teeth.elasticity * teeth.elasticity /
                          (kReferenceCosine * kReferenceCosine) * load.force_N /
                          (z1 * load.module_mm) * (1.0 + sign * z1 / z2) * teeth.flank_factors /
                          (teeth.flank_MPa * teeth.flank_MPa);
  const T at_pitch_point =
      constant / mesh.tangent * ((1.0 / 3.0) * greatest(T(4.0 - mesh.contact_ratio), T(0.0)));
  // Z_B^2 is at least 1.
  if (!(lowest(inner) > 0.0) || !(lowest(of_mate) > 0.0)) return at_pitch_point;
  return at_pitch_point * greatest(T(squared(mesh.tangent) / (inner * of_mate)), T(1.0));
}

template <class T>
RingShaper<T> ring_shaper(const LoadedTeeth& teeth, const GearMesh<T>& mesh) {
  const CutGear<T>& ring = mesh.second;
  RingShaper<T> shaper;
  shaper.teeth = teeth.shaper_teeth.value_or(mesh.first.teeth);
  shaper.base = 0.5 * shaper.teeth * kReferenceCosine;
  const double between = ring.teeth - shaper.teeth;
  if (!(between > 0.0)) return shaper;
  const T working = (2.0 * kReferenceTangent / between) * ring.shift + kReferenceInvolute;
  if (!(lowest(working) > 0.0)) return shaper;
  shaper.tangent = tangent_of_involute(working);
  shaper.centre = (0.5 * between * kReferenceCosine) * root(squared(shaper.tangent) + 1.0);
  shaper.tip = ring.shift - shaper.centre + (0.5 * ring.teeth + teeth.shaper_depth);
  const double half_land_rad = kPi / (2.0 * shaper.teeth) + kReferenceInvolute;
  const T tip_tangent = root(squared((1.0 / shaper.base) * shaper.tip) - 1.0);
  const T land_rad = half_land_rad - involute(tip_tangent);
  shaper.is_pointed = highest(land_rad) < 0.0;
  if (!(lowest(land_rad) >= 0.0)) return shaper;
  const T string = mesh.tangent_distance() + mesh.first.reach() -
                   (0.5 * between * kReferenceCosine) * shaper.tangent;
  shaper.largest = (squared(shaper.tip) - shaper.base * shaper.base - squared(string)) /
                   (2.0 * (shaper.tip - string));
  const double stated = teeth.shaper_radius.value_or(kRingFilletRadius);
  const T wanted =
      teeth.shaper_radius ? T(stated) : T(greatest(least(shaper.largest, T(stated)), T(0.0)));
  shaper.rounding =
      least(wanted, whole_rounding(shaper.tip, shaper.base, half_land_rad, 1.1 * stated));
  shaper.exists = lowest(T(shaper.tip - shaper.rounding)) > shaper.base;
  return shaper;
}

double worst_place(const GearMesh<double>& mesh, const RingShaper<double>& shaper) {
  const Trochoid<double> path = trochoid(mesh, shaper);
  const auto stress = [&](double place) {
    const NotchFactors<double> factors = at_place(mesh, shaper, path, place);
    return factors.form * factors.stress;
  };
  constexpr int kSections = 6;
  std::array<double, kSections + 1> at{};
  int best = 0;
  for (int i = 0; i <= kSections; ++i) {
    at[i] = stress(i / double{kSections});
    if (at[i] > at[best]) best = i;
  }
  double place = best / double{kSections}, step = 1.0 / kSections, top = at[best];
  if (best == 0 || best == kSections) return place;
  // Vertices of parabolas through the best place and its neighbours.
  double before = at[best - 1], after = at[best + 1];
  for (int i = 0; i < 2; ++i) {
    const double bow = before - 2.0 * top + after;
    if (!(bow < 0.0)) break;
    const double vertex = place + std::clamp(0.5 * (before - after) / bow, -0.5, 0.5) * step;
    step *= 0.25;
    place = std::clamp(vertex, step, 1.0 - step);
    if (i == 1) break;
    top = stress(place);
    before = stress(place - step);
    after = stress(place + step);
  }
  return place >= 0.0 && place <= 1.0 ? place : 0.5;
}

template <class T>
std::optional<T> ring_root_mm(const LoadedTeeth& teeth, const GearMesh<T>& mesh,
                              const RingShaper<T>& shaper, const MeshLoad& load, double place) {
  NotchFactors<T> factors;
  if (shaper.exists) {
    factors = at_place(mesh, shaper, trochoid(mesh, shaper), place);
  } else if (shaper.is_pointed || std::is_same_v<T, double>) {
    // A rack's tooth, as high as the shaper's addendum and the ring's own, whatever the shift.
    const double radius = teeth.shaper_radius.value_or(kRingFilletRadius);
    const RootFactors rack =
        din3990_ring_root_factors(teeth.shaper_depth + 1.0, {teeth.shaper_depth, radius});
    factors = {T(rack.form), T(rack.concentration)};
  } else {
    return std::nullopt;
  }
  return root_mm(teeth, load, T(factors.form * factors.stress), mesh.contact_ratio,
                 root_limit_MPa(teeth.root, factors.stress, 1.0));
}

template double external_root_mm(const LoadedTeeth&, const GearMesh<double>&, bool, const double&,
                                 const double&, const MeshLoad&, double);
template Affine external_root_mm(const LoadedTeeth&, const GearMesh<Affine>&, bool, const Affine&,
                                 const Affine&, const MeshLoad&, double);
template double flank_mm(const LoadedTeeth&, const GearMesh<double>&, bool, const MeshLoad&);
template Affine flank_mm(const LoadedTeeth&, const GearMesh<Affine>&, bool, const MeshLoad&);
template RingShaper<double> ring_shaper(const LoadedTeeth&, const GearMesh<double>&);
template RingShaper<Affine> ring_shaper(const LoadedTeeth&, const GearMesh<Affine>&);
template std::optional<double> ring_root_mm(const LoadedTeeth&, const GearMesh<double>&,
                                            const RingShaper<double>&, const MeshLoad&, double);
template std::optional<Affine> ring_root_mm(const LoadedTeeth&, const GearMesh<Affine>&,
                                            const RingShaper<Affine>&, const MeshLoad&, double);

}  // namespace torquewright::gearbox::sized
