// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "gearbox/sized_proof/gear_mesh.hpp"
#include "gearbox/sized_proof/loaded_teeth.hpp"

namespace torquewright::gearbox::sized {

// What roots and flanks ask of a face width, for numbers and for enclosures: strength.md,
// tooth_outline.md. Widths in mm, other lengths in modules.

/// Y_F and Y_S.
template <class T>
struct NotchFactors {
  T form, stress;
};

/// A load on a mesh: the force on one planet and the module of its layer.
struct MeshLoad {
  double force_N = 0.0;
  double module_mm = 0.0;
};

/// Of the root of an external gear, cut by a hob of this tip radius. The stress is that of
/// `stress_radius`, the limit that of `limit_radius`: what is below both bounds is below their
/// like.
template <class T>
T external_root_mm(const LoadedTeeth& teeth, const GearMesh<T>& mesh, bool of_second,
                   const T& stress_radius, const T& limit_radius, const MeshLoad& load,
                   double alternating);

/// Of the flanks of a mesh, at the inner point of single contact of the first gear or the second.
template <class T>
T flank_mm(const LoadedTeeth& teeth, const GearMesh<T>& mesh, bool of_second, const MeshLoad& load);

/// The shaper of a mesh's ring at its full depth. tooth_outline.md eq. (11)...(13).
template <class T>
struct RingShaper {
  double teeth = 0.0, base = 0.0;
  T tangent;  ///< Of the working angle of shaper and ring.
  T centre, tip;
  T largest;                ///< Rounding that leaves the planet its involute.
  T rounding;               ///< What it has.
  bool exists = false;      ///< Surely.
  bool is_pointed = false;  ///< Surely.
};

template <class T>
RingShaper<T> ring_shaper(const LoadedTeeth& teeth, const GearMesh<T>& mesh);

/// A place on the root of a ring, as a share of its trochoid, where the stress is greatest.
double worst_place(const GearMesh<double>& mesh, const RingShaper<double>& shaper);

/// Of the root of a ring, at a place of it; nothing where that is not known of all the box.
template <class T>
std::optional<T> ring_root_mm(const LoadedTeeth& teeth, const GearMesh<T>& mesh,
                              const RingShaper<T>& shaper, const MeshLoad& load, double place);

}  // namespace torquewright::gearbox::sized
