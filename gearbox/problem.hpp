// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gearbox/synthesis_request.hpp"
#include "io/text/rational.hpp"

namespace torquewright::gearbox {

using io::Rational;

enum class ConstraintSet {
  kPaper,      ///< Equations (2)-(9) of seed 001 alone.
  kBuildable,  ///< All that is needed to cut and assemble the gears; docs/gearbox_constraints.md.
};

enum class Objective {
  kPaperCost,
  kMass,
  kHollowShaft,
  kForwardEfficiency,
  kBackwardEfficiency,
  kReflectedInertia,
};

/// Objectives with their names in documents.
inline constexpr std::array<std::pair<Objective, std::string_view>, 6> kObjectives{
    {{Objective::kPaperCost, "paper_cost"},
     {Objective::kMass, "mass"},
     {Objective::kHollowShaft, "hollow_shaft"},
     {Objective::kForwardEfficiency, "forward_efficiency"},
     {Objective::kBackwardEfficiency, "backward_efficiency"},
     {Objective::kReflectedInertia, "reflected_inertia"}}};

constexpr std::string_view objective_name(Objective objective) {
  for (const auto& [each, name] : kObjectives) {
    if (each == objective) return name;
  }
  return "";
}

/// Cutters of the teeth, as far as the document states them; lengths in modules. What is absent is
/// assumed: docs/gearbox_constraints.md, "Cutters".
struct StatedCutters {
  std::optional<Rational> hob_tip_radius = {};     ///< Tip radius of the hob of sun and planets.
  std::optional<Rational> shaper_tip_radius = {};  ///< Tip radius of the shaper of rings.
  std::optional<std::int64_t> shaper_teeth = {};   ///< Teeth of the shaper of rings.
  /// Depth of the hob below its middle line; 1.25 where absent.
  std::optional<Rational> hob_addendum = {};
  /// Depth of the shaper beyond its pitch circle; 1.25 where absent.
  std::optional<Rational> shaper_addendum = {};

  /// Depths of the roots of sun and planets, and of rings.
  Rational hob_depth() const { return hob_addendum.value_or(Rational(5, 4)); }
  Rational shaper_depth() const { return shaper_addendum.value_or(Rational(5, 4)); }
};

/// A document of kind `gearbox_problem`: which teeth are sought. Every number is the decimal that
/// was written.
struct Problem {
  std::string name;
  std::string topology;      ///< One of train_parts.cpp.
  Rational target_ratio;     ///< Input speed over output speed, signed.
  Rational ratio_tolerance;  ///< Relative; 0 is exact.
  Rational rotor_inner_diameter_mm;
  std::vector<Rational> module_mm;         ///< Choices, ascending, at least one.
  std::vector<std::int64_t> planet_count;  ///< Choices, ascending, at least one.
  /// Least teeth by gear: sun, planet_1, planet_2 (planet).
  std::map<std::string, std::int64_t> min_teeth;
  Rational min_carrier_clearance_rad;  ///< alpha_min of equation (6).
  ConstraintSet constraints = ConstraintSet::kPaper;
  Objective objective = Objective::kPaperCost;

  Rational min_contact_ratio = Rational(6, 5);
  /// Least clearance from tip to tip; it must be exceeded.
  Rational min_neighbour_clearance_mm = 0;
  /// Diameter that the rings' blanks have to fit into, under `buildable`. Default: the rotor's
  /// bore.
  std::optional<Rational> ring_outer_diameter_mm;
  std::optional<Rational> ring_wall_mm;  ///< Wall behind the ring's root; default 2.25 module.
  bool sun_under_second_layer = true;    ///< The sun reaches under planet 2.
  StatedCutters cutters = {};

  /// Friction coefficient of the teeth; dimensionless.
  std::optional<Rational> friction_coefficient;
  std::optional<Rational> load_output_torque_Nm;
  std::optional<Rational> load_cycles;  ///< How often the most loaded tooth takes that load.
  /// Sun rim, rotor tube and gap, on each side. Default: the rim that the mass counts, a ring's
  /// wall.
  std::optional<Rational> hollow_shaft_wall_mm;
  /// Face widths of layer_1, layer_2 (planetary: layer_1).
  std::map<std::string, Rational> face_width_mm;
  std::optional<Rational> density_kg_m3;
  std::optional<std::string> steel;  ///< Of all gears; one of strength/steels.hpp.
  Rational rotor_inertia_kg_m2 = 0;  ///< Inertia of the motor's rotor, about its own axis.
  Floors floors = {};
  std::optional<SynthesisRequest> synthesis;
  std::vector<std::string> assumed;  ///< JSON pointers of assumed values.
};

/// What a synthesis makes the teeth bear at the output: the load, or a floor above it.
inline Rational torque_to_bear_Nm(const Problem& problem) {
  const Rational load_Nm = problem.load_output_torque_Nm.value_or(0);
  return std::max(load_Nm, problem.floors.torque_borne_Nm.value_or(load_Nm));
}

/// A design: all tooth counts in the topology's order, planets and module.
struct Design {
  std::vector<std::int64_t> teeth;
  std::int64_t planet_count = 0;
  Rational module_mm;
  /// Profile shift of each gear in its modules, in the same order; empty: none is shifted.
  std::vector<double> profile_shift = {};
  /// Module of planet 2 and the output ring, in mm, where it differs from that of the sun's layer.
  std::optional<Rational> layer_2_module_mm = {};

  /// Whether it has shifts or a second module; search and proofs know only designs without.
  bool is_shifted() const { return !profile_shift.empty() || layer_2_module_mm.has_value(); }

  friend bool operator==(const Design&, const Design&) = default;
};

}  // namespace torquewright::gearbox
