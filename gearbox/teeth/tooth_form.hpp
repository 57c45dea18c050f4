// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace torquewright::gearbox {

/// Reference pressure angle of all gears [rad].
inline constexpr double kPressureAngle_rad = 0.34906585039886591538;

/// One gear, every length in modules. An internal gear is described by its tooth space, which has
/// the shape of the external tooth of as many teeth (docs/derivations/tooth_outline.md).
struct ToothForm {
  std::int64_t teeth = 0;
  bool internal = false;
  double profile_shift = 0.0;  ///< x; of a ring positive outwards. Dimensionless.
  double tip_radius = 0.0;
  double root_radius = 0.0;
  double fillet_radius = 0.0;  ///< External: tip radius of the hob. Internal: root fillet.
};

/// A gear with addendum 1 and dedendum 1.25, cut by the hob of ISO 53 profile A. Requires at least
/// kMinDrawnTeeth teeth; throws std::invalid_argument otherwise and where the tip is pointed.
ToothForm external_gear(std::int64_t teeth, double profile_shift = 0.0);

/// A ring with addendum 1 and dedendum 1.25. Requires at least kMinDrawnTeeth teeth; throws
/// std::invalid_argument otherwise and where the flanks of a space cross before its root.
ToothForm internal_gear(std::int64_t teeth, double profile_shift = 0.0);

/// An external gear that runs in `ring` at `center_distance` [modules]: its hob is rounded only as
/// much as lets the involute reach down to the ring's tip (eq. (8)). Where that is below the base
/// circle no hob helps: the standard one remains, and the two gears interfere.
ToothForm external_gear_in_ring(std::int64_t teeth, double profile_shift, const ToothForm& ring,
                                double center_distance);

/// With fewer teeth the flanks of a standard ring's space cross before its root.
inline constexpr std::int64_t kMinDrawnTeeth = 7;

double base_radius(const ToothForm& form);

/// Half the tooth's (internal: the space's) angle on the base circle [rad], eq. (2).
double base_half_angle_rad(const ToothForm& form);

/// Half the tooth's (internal: the space's) angle at a radius not below the base circle, as far as
/// the involute goes [rad], eq. (1). Negative beyond the point where the flanks cross.
double half_angle_rad(const ToothForm& form, double radius);

}  // namespace torquewright::gearbox
