// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "gearbox/teeth/tooth_form.hpp"

namespace torquewright::gearbox {

/// A point of a gear's plane by radius [modules] and angle from the middle of the tooth (internal:
/// of the space) [rad].
struct PolarPoint {
  double radius = 0.0;
  double angle_rad = 0.0;
};

/// The root of an external tooth as the rounded tip of a hob cuts it: a trochoid, eqs. (3)-(6).
struct HobTrochoid {
  double pitch_radius = 0.0;
  double half_pitch_rad = 0.0;
  double hob_tip_radius = 0.0;
  /// Offset of the arc's centre from the middle of the hob's tooth.
  double arc_center_offset = 0.0;
  /// Height of the arc's centre above the rolling line; negative below it.
  double arc_center_height = 0.0;
  double end_normal_rad = 0.0;  ///< Normal at which the trochoid meets the involute.
};

HobTrochoid hob_trochoid(const ToothForm& external);

/// Point where the hob's arc cuts with its normal at `normal_rad` below the rolling line: pi/2 at
/// the root circle, the pressure angle at the end of the hob's straight flank.
PolarPoint trochoid_point(const HobTrochoid& trochoid, double normal_rad);

/// The circular root fillet of a ring, tangent to the root circle and to the involute, eq. (7).
struct RingFillet {
  /// Radius of the form, or what finds room between the flanks of a narrow space.
  double radius = 0.0;
  PolarPoint center;
  PolarPoint flank_end;  ///< Point where it touches the involute.
};

RingFillet ring_fillet(const ToothForm& internal);

/// The root of a ring as the rounded tip of a shaper cuts it: a trochoid, eqs. (14)-(16).
struct ShaperTrochoid {
  /// Ratio of the ring's turn to the shaper's: its teeth over the ring's.
  double teeth_ratio = 0.0;
  double center_distance = 0.0;    ///< Centre distance of shaper and ring at full depth.
  double pitch_point = 0.0;        ///< Distance of the pitch point from the ring's axis.
  double tip_radius = 0.0;         ///< Rounding of the shaper's tips.
  double arc_center_radius = 0.0;  ///< Distance of the arc's centre from the shaper's axis.
  /// Angle of the arc's centre from the middle of the shaper's tooth.
  double arc_center_angle_rad = 0.0;
  double end_turn_rad = 0.0;  ///< Turn at which the trochoid meets the involute.
};

/// Returns the trochoid; nothing where the ring's shaper is not known or does not mesh with it.
std::optional<ShaperTrochoid> shaper_trochoid(const ToothForm& internal);

/// Point where the rounding cuts when its centre stands at `turn_rad` from the line of centres,
/// seen from the shaper's axis: 0 at the root circle, the trochoid's end at the involute.
PolarPoint trochoid_point(const ShaperTrochoid& trochoid, double turn_rad);

/// Radius of the trochoid's curvature there, eq. (22); concave towards the space.
double curvature_radius(const ShaperTrochoid& trochoid, double turn_rad);

}  // namespace torquewright::gearbox
