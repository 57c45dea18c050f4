// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "io/text/rational.hpp"

namespace torquewright::gearbox {

/// What a problem lets its synthesis choose beside teeth, planets and module: `synthesis` in a
/// gearbox_problem.
struct SynthesisRequest {
  /// Modules that planet 2 and the output ring may have, ascending; empty: that of the sun's layer.
  std::vector<io::Rational> layer_2_module_mm = {};
  /// By how many teeth a ring may differ from the coaxial one; shifts close the distance.
  std::int64_t ring_teeth_off = 1;
  io::Rational least_shift = io::Rational(-1, 2);  ///< Of sun and planets, in modules.
  io::Rational greatest_shift = 1;
  io::Rational least_tip_thickness = io::Rational(1, 5);  ///< Of every tooth, in modules.
  io::Rational least_face_width_mm = 1;
  std::optional<io::Rational> greatest_face_width_mm = {};
  /// Of a layer, over its module and over the pitch diameter of its smallest sun or planet.
  std::optional<io::Rational> greatest_face_width_over_module = {};
  std::optional<io::Rational> greatest_face_width_over_diameter = {};
  /// Relative gap between objective and bound at which it is called optimal.
  io::Rational gap = io::Rational(1, 1000);
};

/// Floors and ceilings on what is reported of a design.
struct Floors {
  std::optional<io::Rational> forward_efficiency = {};
  std::optional<io::Rational> backward_efficiency = {};
  std::optional<io::Rational> hollow_shaft_mm = {};
  /// Greatest sum of the layers' face widths.
  std::optional<io::Rational> axial_length_mm = {};
  std::optional<io::Rational> mass_kg = {};                  ///< Greatest, of the gears.
  std::optional<io::Rational> reflected_inertia_kg_m2 = {};  ///< Greatest, at the output.
  /// Greatest, at the output for the same backlash along every mesh's line of action.
  std::optional<io::Rational> backlash_rad_per_mm = {};
  /// Least, at the output for the load's cycles; where a synthesis makes the teeth as wide as that.
  std::optional<io::Rational> torque_borne_Nm = {};
  /// Least, of the teeth at the output; where a synthesis makes the teeth as wide as that.
  std::optional<io::Rational> stiffness_Nm_rad = {};
};

}  // namespace torquewright::gearbox
