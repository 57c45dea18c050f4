// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearbox/sized_proof/enclosures/affine.hpp"
#include "gearbox/sized_proof/loaded_teeth.hpp"

namespace torquewright::gearbox::sized {

/// What `evaluate` forgives of a condition by rounding.
inline constexpr double kForgiven = 1e-9;

/// What a layer's terms are asked for.
struct Demands {
  bool inertia = false;
  bool efficiency = false;
  std::optional<double> hollow_shaft_mm = {};  ///< At least.
  /// What is heavier, as far as the layer alone is, is of no interest.
  double heaviest_kg = kInfinity;
};

/// A layer at a centre distance and a shift, or over a box of them.
template <class T>
struct LayerTerms {
  std::vector<T> margins;   ///< A design exists only where none is below 0.
  std::vector<T> width_mm;  ///< What asks something of the face width: the greatest is taken.
  T kg_per_mm;              ///< Mass of a millimetre of width.
  T kg_m2_per_mm;           ///< Inertia at the output, likewise.
  T softness{0.0};          ///< Of the teeth at the output times the width, rad mm/Nm, if asked.
  /// Of the layer's meshes: that of the sun, if it is here, and that of the ring.
  std::array<T, 2> efficiency{T(1.0), T(1.0)};
  /// Surely no design, or only ones of no interest: the lists are not complete.
  bool is_closed = false;
};

LayerTerms<double> layer_terms(const LoadedTeeth& teeth, std::size_t layer, double centre_mm,
                               double shift, const Demands& demands);
LayerTerms<Affine> layer_terms(const LoadedTeeth& teeth, std::size_t layer, const Affine& centre_mm,
                               const Affine& shift, const Demands& demands);

/// From the sun's tip to that of planet 2, where it reaches below: m1 (z1/2 + x1 - 1) - m2 (z2/2 +
/// x2 + 1), since the sun's tip keeps its clearance to planet 1's root.
double sun_clearance_mm(const LoadedTeeth& teeth, double shift_1, double shift_2);

/// Centre distances that shifts of sun and planet 1 may close, where rings reach around planets.
struct CentreRange {
  double low_mm = 0.0, high_mm = 0.0;
};
CentreRange centre_range(const LoadedTeeth& teeth);

}  // namespace torquewright::gearbox::sized
