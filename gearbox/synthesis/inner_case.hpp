// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gearbox/problem.hpp"
#include "gearbox/synthesis/slope.hpp"

namespace torquewright::gearbox {

/// Whole numbers and modules of a train: what is left is continuous.
struct TrainChoice {
  /// Sun, planet 1, planet 2, ring of the sun's layer, ring of the other; 0: there is none.
  std::array<std::int64_t, 5> teeth{};
  std::int64_t planet_count = 0;
  std::array<std::size_t, 2> module{};  ///< By layer: places in the lists of modules.
};

/// What a tooth's root may be stressed with, by its notch: static_MPa (slope Y_S + constant) once,
/// and for the cycles its blend with the endurance. docs/derivations/strength.md eq. (11), (12).
struct RootLimit {
  double static_MPa = 0.0;
  double notch_slope = 0.0;
  double notch_constant = 0.0;
  double endurance_MPa = 0.0;
  double static_weight = 1.0;  ///< Exponent of the static limit in the limit for the cycles.
};

/// Up to this shift the stress of a root loaded at the tip falls with the rounding of its tool, on
/// the grid of RestsOnRootsThatARounderToolMakesStronger; beyond, wide boxes are bounded without
/// that.
inline constexpr double kGreatestRuledShift = 1.1;

/// All numbers of the inner problem but its three variables. Lengths in mm, in modules where said.
struct InnerCase {
  std::array<double, 5> teeth{};
  bool has_first_ring = true;  ///< Without, planet 1 meshes with the sun alone.
  /// Without, the second layer is nothing: of no mass, width or loss, and feasible.
  bool has_second_layer = true;
  std::size_t held_layer = 0;               ///< Where the held ring is.
  std::optional<std::size_t> output_layer;  ///< Where the output ring is; absent: the carrier.
  std::array<double, 2> basic_ratio{};      ///< I1, I2 of train/central_gears.hpp.
  double carrier_speed_per_sun = 0.0;
  double planet_speed_per_sun = 0.0;
  double planets = 0.0;
  double sine_of_half_spacing = 0.0;  ///< sin(pi/n)
  std::array<double, 2> module_mm{};  ///< By layer.
  std::array<double, 2> wall_mm{};    ///< Behind roots, by layer.
  double ring_space_mm = 0.0;
  double hob_depth = 1.25;  ///< In modules, as the next.
  double shaper_depth = 1.25;
  double undercut_depth = 1.0;
  std::optional<double> hob_tip_radius;
  std::optional<double> shaper_tip_radius;
  std::optional<double> shaper_teeth;
  double min_contact_ratio = 1.2;
  double min_neighbour_clearance_mm = 0.0;
  double min_tip_thickness = 0.0;  ///< In modules, as the shifts of sun and planets.
  double least_shift = 0.0;
  double greatest_shift = 0.0;
  bool sun_under_second_layer = true;
  std::optional<double> min_hollow_shaft_mm;
  double hollow_shaft_wall_mm = 0.0;
  std::array<double, 2> max_face_width_mm{};  ///< By layer; infinite: none.
  std::optional<double> max_axial_length_mm;
  double min_face_width_mm = 0.0;
  std::optional<double> friction;
  std::optional<double> min_forward_efficiency;
  std::optional<double> min_backward_efficiency;
  std::optional<double> max_mass_kg;
  std::optional<double> max_gear_inertia_kg_m2;  ///< At the output, without the rotor.
  double ratio = 1.0;                            ///< Sun over output.
  std::optional<double> most_softness_rad_Nm;    ///< Of the teeth at the output.
  /// Of the mesh with the sun, with the ring of each layer: softness times width with teeth of a
  /// contact ratio of 1 (strength.md eq. (16)), in rad mm/Nm.
  std::array<double, 3> mesh_softness{};

  /// Tangential force at the reference circle, of one planet's meshes with the sun and the ring of
  /// each layer, under the load: it does not depend on shifts.
  std::array<double, 3> reference_force_N{};
  RootLimit root;
  double alternating_bending = 1.0;  ///< Of planet 1: 1 unless it turns between sun and held ring.
  double root_factors = 1.0;         ///< All K and the demanded safety.
  double flank_factors = 1.0;        ///< All K and the square of the demanded safety.
  double flank_limit_MPa = 0.0;
  double elasticity = 0.0;
  double density_kg_m3 = 0.0;
};

/// What rounding may make of a margin here and in `evaluate`.
inline constexpr double kMarginSlack = 1e-9;

/// Margins, widths and mass per width of a layer at a point, or their enclosures over a box.
template <class T>
struct LayerValues {
  std::vector<T> margins;   ///< A design exists only where none is below 0.
  std::vector<T> width_mm;  ///< What each tooth asks of the face width; the greatest is taken.
  T mass_per_width_kg_mm;
  /// Inertia at the output of a width, likewise; 0 over boxes where nothing is asked of it.
  T inertia_per_width_kg_m2_mm;
  /// Turn of the output for its torque, times the width, in rad mm/Nm; 0 where none is asked.
  T softness_rad_mm_Nm{0.0};
  /// Basic efficiencies of the layer's meshes, 1 without friction or mesh: of sun and ring, or of
  /// the ring and 1.
  std::array<T, 2> efficiency;
};

/// The values of a layer (0: that of the sun) at a centre distance and a shift, NaN where the gears
/// do not exist.
LayerValues<double> layer_values(const InnerCase& inner, std::size_t layer, double centre_mm,
                                 double shift);
/// Enclosures over a box, which must outlive them. What cannot be enclosed has no finite bound, or
/// is left out of the list of widths; the lists end where a margin is below 0 all over the box, or
/// the layer heavier than the cutoff or wider than it may be. A ring's root is that at the place of
/// the greatest stress amid the box: any place bounds the greatest from below.
LayerValues<Slope> layer_values(const InnerCase& inner, std::size_t layer, const InnerPlace& box,
                                double cutoff_kg);

/// Names of the layer's margins, in their order.
std::vector<std::string> margin_names(const InnerCase& inner, std::size_t layer);

/// m1 (z1/2 - 1 + x1) - m2 (z2/2 + 1 + x2): the sun's tip clears planet 2; not below 0 where the
/// sun reaches under the second layer.
double sun_clearance_mm(const InnerCase& inner, double shift_1, double shift_2);

/// Efficiencies of the train from those of its meshes, growing with each: forwards, backwards.
std::array<double, 2> train_efficiencies(const InnerCase& inner, double sun, double first_ring,
                                         double second_ring);

}  // namespace torquewright::gearbox
