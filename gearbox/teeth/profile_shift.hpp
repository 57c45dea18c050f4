// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace torquewright::gearbox {

// Lengths in modules, angles in rad, shifts x in modules. Formulas: docs/derivations/kinematics.md,
// "Profile shift".

enum class MeshKind { kExternal, kInternal };

/// Two gears in mesh; in an internal mesh gear 2 is the ring.
struct ShiftedPair {
  MeshKind kind = MeshKind::kExternal;
  double teeth_1 = 0.0;
  double teeth_2 = 0.0;
  double shift_1 = 0.0;
  double shift_2 = 0.0;
};

/// Returns the angle whose involute tan(angle) - angle is `involute`; nothing for a negative
/// involute.
std::optional<double> inverse_involute_rad(double involute);

/// Returns the pressure angle at which the pair meshes without backlash; nothing where none exists.
std::optional<double> working_angle_rad(const ShiftedPair& pair);

/// Returns the sum of the teeth (external) or their difference (internal).
double teeth_between_centres(const ShiftedPair& pair);

/// Returns the centre distance at a working angle, in modules.
double centre_distance(const ShiftedPair& pair, double working_angle_rad);

/// Returns the working angle at a centre distance in modules; nothing where the base circles do not
/// allow it.
std::optional<double> working_angle_at_rad(double teeth_between_centres, double centre_distance);

/// Returns y = a - (z1 +- z2)/2: how far the centres are from their reference distance, in modules.
double centre_increment(const ShiftedPair& pair, double centre_distance);

/// Returns the sum of shifts that closes a centre distance in modules: x1 + x2 (external), x2 - x1
/// (internal).
std::optional<double> closing_shift(const ShiftedPair& pair, double centre_distance);

/// Tip diameter of an external gear of a pair that keeps the full tip clearance to its mate.
double tip_diameter_keeping_clearance(double teeth, double mate_shift, double centre_increment);

/// Tip diameter of an external gear, d = z + 2 (1 + x).
double tip_diameter_external(double teeth, double shift);

/// Tip diameter of planet 1, which meets the sun and a ring: the smaller of the two above.
double tip_diameter_planet_1(double teeth, double shift, double sun_shift, double centre_increment);

/// Tip diameter of a ring, d = z - 2 (1 - x).
double tip_diameter_ring(double teeth, double shift);

}  // namespace torquewright::gearbox
