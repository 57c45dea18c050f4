// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gearbox/sized_proof/enclosures/affine.hpp"
#include "gearbox/teeth/tooth_geometry.hpp"

namespace torquewright::gearbox::sized {

// Involute gears at a centre distance, for numbers and for enclosures. Lengths in modules.
// kinematics.md "Profile shift", tooth_outline.md eq. (1), (8).

template <class T>
struct CutGear {
  double teeth = 0.0;
  T shift;
  T tip;      ///< Diameter.
  T tangent;  ///< Of the pressure angle at the tip.

  double base() const { return 0.5 * teeth * kReferenceCosine; }
  /// From the base circle's tangent point to the tip.
  T reach() const { return base() * tangent; }
  T root_radius(double depth) const { return shift + (0.5 * teeth - depth); }
};

template <class T>
CutGear<T> cut_gear(double teeth, const T& shift, const T& tip) {
  return {teeth, shift, tip, root(squared((1.0 / (teeth * kReferenceCosine)) * tip) - 1.0)};
}

/// Half the angle of a tooth (of a ring: of a space) where the pressure angle has this tangent.
template <class T>
T half_angle_rad(const CutGear<T>& gear, const T& tangent) {
  return (2.0 * kReferenceTangent / gear.teeth) * gear.shift - involute(tangent) +
         (kPi / 2.0 / gear.teeth + kReferenceInvolute);
}

/// An external gear and its mate: outside, or a ring around it.
template <class T>
struct GearMesh {
  bool is_inside = false;
  CutGear<T> first, second;
  T centre;
  T tangent;           ///< Of the working angle.
  T approach, recess;  ///< Of the path of contact, in base pitches.
  T contact_ratio;

  double between() const {
    return is_inside ? second.teeth - first.teeth : second.teeth + first.teeth;
  }
  /// Of the base circles' tangent points.
  T tangent_distance() const { return (0.5 * between() * kReferenceCosine) * tangent; }
  /// From the first gear's tangent point to where the mate's tip touches it.
  T deepest_on_first() const {
    return is_inside ? T(second.reach() - tangent_distance())
                     : T(tangent_distance() - second.reach());
  }
  T deepest_on_second() const { return tangent_distance() - first.reach(); }  ///< Outside only.
};

template <class T>
T working_tangent(double between, const T& centre) {
  return root(squared((2.0 / (between * kReferenceCosine)) * centre) - 1.0);
}

/// Sum (in a ring: difference) of the shifts that fills a centre distance.
template <class T>
T closing_shifts(double between, const T& tangent) {
  return (0.5 * between / kReferenceTangent) * (involute(tangent) - kReferenceInvolute);
}

template <class T>
GearMesh<T> meshed(bool is_inside, const CutGear<T>& first, const CutGear<T>& second,
                   const T& centre, const T& tangent) {
  GearMesh<T> mesh{is_inside, first, second, centre, tangent, T(0.0), T(0.0), T(0.0)};
  const double sign = is_inside ? -1.0 : 1.0;
  mesh.approach = (0.5 * sign * second.teeth / kPi) * (second.tangent - tangent);
  mesh.recess = (0.5 * first.teeth / kPi) * (first.tangent - tangent);
  mesh.contact_ratio = mesh.approach + mesh.recess;
  return mesh;
}

/// Largest tip radius of the hob that leaves the involute from `deepest` on.
template <class T>
T largest_hob_radius(double hob_depth, const CutGear<T>& gear, const T& deepest) {
  return (kReferenceSine * deepest - gear.shift +
          (hob_depth - 0.5 * kReferenceSine * kReferenceSine * gear.teeth)) /
         (1.0 - kReferenceSine);
}

/// Thickness of an external tooth at its tip.
template <class T>
T tip_thickness(const CutGear<T>& gear) {
  return gear.tip * half_angle_rad(gear, gear.tangent);
}

template <class T>
T ring_tip_thickness(const CutGear<T>& ring) {
  return ring.tip * (kPi / ring.teeth - half_angle_rad(ring, ring.tangent));
}

/// Of a planet's and its ring's tips where they leave each other; at least 0.
template <class T>
T trochoid_margin_rad(const GearMesh<T>& mesh) {
  const T r1 = 0.5 * mesh.first.tip, r2 = 0.5 * mesh.second.tip;
  const T squares = squared(r2) - squared(r1), apart = squared(mesh.centre);
  const T at_planet = arc_cosine((squares - apart) / (2.0 * mesh.centre * r1));
  const T at_ring = arc_cosine((squares + apart) / (2.0 * mesh.centre * r2));
  const T working = involute(mesh.tangent);
  return (mesh.first.teeth / mesh.second.teeth) *
             (at_planet + involute(mesh.first.tangent) - working) +
         working - involute(mesh.second.tangent) - at_ring;
}

/// Mean distance from the pitch point over the pairs that share the load. efficiency.md eq. (8).
template <class T>
T sliding_factor(const GearMesh<T>& mesh) {
  const T two = least(mesh.contact_ratio - 1.0, T(1.0));
  const T three = greatest(mesh.contact_ratio - 2.0, T(0.0));
  const auto zone = [&](const T& end) -> T {
    const T inner = signed_square(T(end - three));
    return (1.0 / 3.0) * (signed_square(end) - inner) + 0.5 * (inner - signed_square(T(end - two)));
  };
  const T middle = signed_square(T(1.0 - mesh.approach)) + signed_square(T(1.0 - mesh.recess));
  return zone(mesh.approach) + zone(mesh.recess) + greatest(middle, T(0.0)) +
         (1.0 / 3.0) * greatest(T(-1.0 * middle), T(0.0));
}

template <class T>
T mesh_efficiency(const GearMesh<T>& mesh, double friction) {
  const double curvature =
      1.0 / mesh.first.teeth + (mesh.is_inside ? -1.0 : 1.0) / mesh.second.teeth;
  return 1.0 - (friction * kPi * curvature) * sliding_factor(mesh);
}

}  // namespace torquewright::gearbox::sized
