// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "hopper/planning/plane/stance.hpp"
#include "optimization/nonlinear/program.hpp"

namespace torquewright::hopper {

/// A phase and its mesh, in shares of its duration from 0 to 1.
struct MeshPhase {
  Stance stance;
  std::vector<double> knots;
  optimization::Bounds duration_s;
  double guess_s = 0.0;  ///< How long a first guess takes it; 0: the middle of its bounds.

  std::size_t intervals() const { return knots.size() - 1; }
  /// Instants: knots and middles in turn.
  std::size_t points() const { return 2 * intervals() + 1; }
  /// Where an instant is.
  double share_at(std::size_t point) const {
    const std::size_t i = point / 2;
    return point % 2 == 0 ? knots[i] : 0.5 * (knots[i] + knots[i + 1]);
  }
};

/// How far from the middle of the sole the mass may stand at the begin and at the end, as a share
/// of the foot's length.
inline constexpr double kStandsWithin = 0.1;

/// Goal of a plan beside obeying physics.
struct PlanGoal {
  double turn_rad = 0.0;           ///< Turn of the foot, forwards.
  std::optional<double> stride_m;  ///< Stride of the foot; empty: free.
  std::optional<double> rise_m;    ///< Least rise of the centre of mass in flight.
  /// The range in which each joint that moves stands at the begin and at the end, in rad.
  std::vector<optimization::Bounds> standing_rad;
  /// Whether the base is level at the beginning, and turned by `turn_rad` at the end: for a foot of
  /// one point, whose own pitch is free.
  bool has_level_base = false;
};

}  // namespace torquewright::hopper
