// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace torquewright::gearbox {

/// Heat treatment of the teeth, which decides a material's strength against few loads.
enum class Treatment {
  kCaseHardened,
  kThroughHardened,
  kNitrided,
};

/// Steel of the gears, stresses in MPa. The endurance limits are those of the standard's reference
/// gears (DIN 3990-5, ISO 6336-5): what their own tables print.
struct GearMaterial {
  Treatment treatment = Treatment::kCaseHardened;
  double young_MPa = 0.0;
  double poisson = 0.0;
  double bending_endurance_MPa = 0.0;  ///< sigma_Flim, nominal; the smooth root bears twice that.
  double contact_endurance_MPa = 0.0;  ///< sigma_Hlim.
  std::optional<double> yield_MPa;     ///< Needed for kThroughHardened.
};

/// Strength of a place of the tooth: `static_MPa` up to `static_cycles` loads, `endurance_MPa` from
/// `endurance_cycles` on, a straight line in logarithms between. DIN 3990-11 (4.04), (5.04).
struct LifeCurve {
  double static_MPa = 0.0;
  double static_cycles = 0.0;
  double endurance_MPa = 0.0;
  double endurance_cycles = 0.0;

  double at_MPa(double cycles) const;
};

/// Returns the life curve of a tooth's root over the local stress. `concentration` is Y_S with the
/// load at the outer point of single contact; `endurance_share` is below 1 for a tooth that is bent
/// both ways. docs/derivations/strength.md eq. (11), (12). Requires yield_MPa of a through-hardened
/// material.
LifeCurve root_life(const GearMaterial& material, double concentration, double endurance_share);

/// Returns the life curve of a tooth's flank over the Hertzian pressure, no pits permitted.
/// docs/derivations/strength.md eq. (13).
LifeCurve flank_life(const GearMaterial& material);

}  // namespace torquewright::gearbox
