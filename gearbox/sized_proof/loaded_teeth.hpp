// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "gearbox/problem.hpp"
#include "gearbox/train_parts.hpp"

namespace torquewright::gearbox::sized {

/// Whole numbers and modules of a train. By layer, that of the sun first; what a train does not
/// have is 0.
struct WholeNumbers {
  std::int64_t sun = 0;
  std::array<std::int64_t, 2> planet{};
  std::array<std::int64_t, 2> ring{};
  std::int64_t planets = 0;
  std::array<Rational, 2> module_mm{};
};

double real(std::int64_t number);
std::optional<double> as_number(const std::optional<Rational>& value);

/// In the topology's order.
std::vector<std::int64_t> teeth_in_order(const TrainParts& parts, const WholeNumbers& whole);

/// What a steel's root bears: its limit for one load is static_MPa (slope Y_S + constant), and for
/// the problem's loads that to the power of `static_share` times the endurance to what is left.
struct RootStrength {
  double static_slope_MPa = 0.0;
  double static_constant_MPa = 0.0;
  double endurance_MPa = 0.0;
  double static_share = 1.0;
};

/// All numbers of a train but its centre distance and the shifts of its planets. Lengths in mm, in
/// modules where said.
struct LoadedTeeth {
  double sun = 0.0;
  std::array<double, 2> planet{}, ring{};
  double planets = 0.0;
  double half_chord = 0.0;  ///< sin(pi/n)
  std::array<double, 2> module_mm{}, wall_mm{}, widest_mm{};
  double least_width_mm = 0.0;
  double ratio = 1.0;  ///< Sun over output.
  /// Speeds over the sun's.
  double carrier_speed = 0.0, planet_speed = 0.0;
  std::array<double, 2> ring_speed{};
  std::optional<std::size_t> output_layer;  ///< Of the ring that is the output; else the carrier.
  std::size_t held_layer = 0;
  /// On the reference circle of one planet's meshes: with the sun, with each layer's ring.
  double sun_force_N = 0.0;
  std::array<double, 2> ring_force_N{};

  /// Least stiffness of the teeth at the output, and of the same meshes: softness there times face
  /// width and c_gamma/c', in rad mm/Nm.
  std::optional<double> least_Nm_rad;
  double sun_softness = 0.0;
  std::array<double, 2> ring_softness{};

  double hob_depth = 1.25, shaper_depth = 1.25, undercut_depth = 1.0;  ///< In modules.
  std::optional<double> hob_radius, shaper_radius, shaper_teeth;
  double hollow_wall_mm = 0.0;
  double space_mm = 0.0;  ///< For the rings' blanks.
  double min_contact_ratio = 1.0, min_neighbour_mm = 0.0;
  double min_tip_thickness = 0.0, least_shift = 0.0, greatest_shift = 0.0;  ///< In modules.
  bool is_sun_below = false;  ///< It reaches under the second layer.

  RootStrength root;
  double alternating = 1.0;  ///< Of the endurance of planet 1, which may be bent both ways.
  double root_factors = 1.0, flank_factors = 1.0;  ///< Factors of load and the demanded safeties.
  double flank_MPa = 0.0, elasticity = 0.0;
  double density_kg_m3 = 0.0, friction = 0.0, rotor_kg_m2 = 0.0;

  bool has_second_layer() const { return planet[1] > 0.0; }
};

LoadedTeeth loaded_teeth(const Problem& problem, const WholeNumbers& whole);

}  // namespace torquewright::gearbox::sized
