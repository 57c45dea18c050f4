// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "hopper/planning/plane/stance.hpp"
#include "optimization/nonlinear/program.hpp"
#include "simulation/contact/ground_profile.hpp"

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
  /// Returns the share of the phase's duration at which an instant stands.
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
  std::optional<double> stride_m;  ///< Stride of the foot in each flight; empty: free.
  /// Height of the ground where each flight lands, in m, over that where the motion begins.
  std::vector<double> landings_m;
  simulation::GroundProfile ground;  ///< With these heights, edges between the places.
  /// How long it takes from the first take-off to the last touch-down; empty: free.
  std::optional<double> hops_s;
  std::optional<double> rise_m;  ///< Least rise of the centre of mass in flight.
  /// The range in which each joint that moves stands at the begin and at the end, in rad.
  std::vector<optimization::Bounds> standing_rad;
  /// Whether the base is level at the beginning, and turned by `turn_rad` at the end: for a foot of
  /// one point, whose own pitch is free.
  bool has_level_base = false;
};

/// How many of the phases before this one are flights.
inline std::size_t flights_before(const std::vector<MeshPhase>& mesh, std::size_t phase) {
  return static_cast<std::size_t>(
      std::count_if(mesh.begin(), mesh.begin() + static_cast<std::ptrdiff_t>(phase),
                    [](const MeshPhase& one) { return one.stance.is_flight(); }));
}

/// How high the ground is where a phase stands, or takes off.
inline double ground_m(const PlanGoal& goal, const std::vector<MeshPhase>& mesh,
                       std::size_t phase) {
  const std::size_t flights = flights_before(mesh, phase);
  return flights == 0 || goal.landings_m.empty() ? 0.0 : goal.landings_m[flights - 1];
}

}  // namespace torquewright::hopper
