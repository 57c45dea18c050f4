// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

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
  double fillet_radius = 0.0;  ///< Tip radius of hob or shaper; else a ring's circular fillet.
  /// Teeth of the shaper that cut a ring's root; 0: not known, the root is drawn with a circular
  /// fillet.
  std::int64_t shaper_teeth = 0;
};

/// Tip radius of the hob of ISO 53 profile A, in modules: assumed where no cutter is stated.
inline constexpr double kHobTipRadius = 0.38;

/// Addendum of hob and shaper in modules, where no other is stated: ISO 53 profiles A, B and C.
inline constexpr double kStandardAddendum = 1.25;

/// Root fillet of a ring, in modules: assumed where no shaper is stated. It stays clear of a
/// standard planet's tip (docs/derivations/tooth_outline.md).
inline constexpr double kRingFilletRadius = 0.3;

/// A gear with addendum 1, cut by a hob of this addendum and else that of ISO 53 profile A.
/// Requires at least kMinDrawnTeeth teeth; throws std::invalid_argument otherwise and where the tip
/// is pointed.
ToothForm external_gear(std::int64_t teeth, double profile_shift = 0.0,
                        double hob_addendum = kStandardAddendum);

/// A ring with addendum 1 and this dedendum. Requires at least kMinDrawnTeeth teeth; throws
/// std::invalid_argument otherwise and where the flanks of a space cross before its root.
ToothForm internal_gear(std::int64_t teeth, double profile_shift = 0.0,
                        double dedendum = kStandardAddendum);

/// A planet in a ring; lengths in modules.
struct PlanetInRing {
  double teeth = 0.0;
  double profile_shift = 0.0;
  double ring_teeth = 0.0;
  double ring_tip_radius = 0.0;
  double center_distance = 0.0;
  double hob_addendum = kStandardAddendum;  ///< Addendum of the hob that cuts the planet.
};

/// Eq. (8): the largest tip radius of the planet's hob that leaves its involute down to where the
/// ring's tip touches it. Negative: no hob does. Nothing where the ring's tip touches no involute
/// at all.
std::optional<double> largest_hob_tip_radius(const PlanetInRing& mesh);

/// An external gear that runs in `ring` at `center_distance` [modules]: its hob is rounded only as
/// much as lets the involute reach down to the ring's tip (eq. (8)). Where that is below the base
/// circle no hob helps: the standard one remains, and the two gears interfere.
ToothForm external_gear_in_ring(std::int64_t teeth, double profile_shift, const ToothForm& ring,
                                double center_distance, double hob_addendum = kStandardAddendum);

/// Fewest teeth of a gear that is drawn: with fewer the flanks of a standard ring's space cross
/// before its root.
inline constexpr std::int64_t kMinDrawnTeeth = 7;

double base_radius(const ToothForm& form);

/// Half the tooth's (internal: the space's) angle on the base circle [rad], eq. (2).
double base_half_angle_rad(const ToothForm& form);

/// Half the tooth's (internal: the space's) angle at a radius not below the base circle, as far as
/// the involute goes [rad], eq. (1). Negative beyond the point where the flanks cross.
double half_angle_rad(const ToothForm& form, double radius);

}  // namespace torquewright::gearbox
