// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "gearbox/teeth/tooth_outline.hpp"

namespace torquewright::report {

/// A piece of a boundary about an axis, counter-clockwise; lengths in mm.
struct OutlinePiece {
  /// Of a Bezier curve its control points, of an arc its two ends.
  std::vector<gearbox::Point> points;
  double arc_radius_mm = 0.0;  ///< Positive: an arc about the axis.

  bool is_arc() const { return arc_radius_mm > 0.0; }
};

/// No Bezier curve of an outline is farther than this from the exact curve: flank or fillet.
inline constexpr double kPieceDeviation_mm = 1e-4;

/// A gear's whole outline, the middle of a tooth (internal: of a space) on the x axis: circles of
/// tip and root as arcs, flanks and fillets as Bezier curves of the least degree from 3 to 7 that
/// keeps within the deviation, in two halves where none does. Each piece begins where the one
/// before it ends. Throws std::invalid_argument where the roots of two teeth cross.
std::vector<OutlinePiece> outline_pieces(const gearbox::ToothForm& form, double module_mm);

/// A circle as two arcs.
std::vector<OutlinePiece> circle_pieces(double radius_mm);

/// The point of a Bezier curve at t from 0 to 1.
gearbox::Point on_bezier(const std::vector<gearbox::Point>& control, double t);

}  // namespace torquewright::report
