// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "gearbox/synthesis_request.hpp"

namespace torquewright::gearbox {

/// What a floor or a ceiling limits.
enum class FloorQuantity {
  kForwardEfficiency,
  kBackwardEfficiency,
  kHollowShaft,
  kAxialLength,
  kMass,
  kReflectedInertia,
  kBacklash,
};

/// One floor or ceiling of a problem, as documents know it.
struct FloorRecord {
  FloorQuantity quantity;
  std::string_view name;     ///< Of the constraint.
  std::string_view key;      ///< Of the bound, a JSON pointer.
  std::string_view unit;     ///< "1": none.
  std::string_view meaning;  ///< Of the value, behind it in a sentence.
  bool is_ceiling;
  std::optional<io::Rational> Floors::*limit;
  bool needs_friction = false;
  bool needs_widths = false;   ///< Where no synthesis chooses them.
  bool needs_density = false;  ///< Of the gears.
};

inline constexpr std::array<FloorRecord, 7> kFloors{
    {{FloorQuantity::kForwardEfficiency, "forward_efficiency", "/min_forward_efficiency", "1",
      "of the power put in comes out with the motor driving", false, &Floors::forward_efficiency,
      true},
     {FloorQuantity::kBackwardEfficiency, "backward_efficiency", "/min_backward_efficiency", "1",
      "of the power put in comes out with the output driving", false, &Floors::backward_efficiency,
      true},
     {FloorQuantity::kHollowShaft, "hollow_shaft", "/min_hollow_shaft_diameter_mm", "mm",
      "left for a hollow shaft", false, &Floors::hollow_shaft_mm},
     {FloorQuantity::kAxialLength, "axial_length", "/max_axial_length_mm", "mm",
      "of face widths in all", true, &Floors::axial_length_mm, false, true},
     {FloorQuantity::kMass, "mass", "/max_mass_kg", "kg", "of gears", true, &Floors::mass_kg, false,
      true, true},
     {FloorQuantity::kReflectedInertia, "reflected_inertia", "/max_reflected_inertia_kg_m2",
      "kg m^2", "of inertia at the output", true, &Floors::reflected_inertia_kg_m2, false, true,
      true},
     {FloorQuantity::kBacklash, "backlash", "/max_backlash_rad_per_mm", "rad/mm",
      "of backlash at the output", true, &Floors::backlash_rad_per_mm}}};

/// The value from which on the floor or ceiling is met: values with roots and angles are compared
/// up to a millionth of a millionth, as objectives are.
inline io::Rational met_from(const FloorRecord& floor, const io::Rational& limit) {
  const io::Rational slack = abs(limit) / 1'000'000'000'000;
  return floor.is_ceiling ? io::Rational(limit + slack) : io::Rational(limit - slack);
}

}  // namespace torquewright::gearbox
