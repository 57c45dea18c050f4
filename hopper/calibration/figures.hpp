// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hopper/calibration/free_value.hpp"

namespace torquewright::hopper::calibration {

/// A published average angular velocity of the whole robot at a posture.
struct SpeedTarget {
  std::size_t posture = 0;  ///< Index in robot.postures.
  double speed_rad_s = 0.0;
};

/// Published figures. CAM is conserved in flight, so CAV = CAM over the inertia of each posture:
/// two published velocities and one momentum determine two inertias.
struct Figures {
  double angular_momentum_Nm_s = 0.0;
  std::vector<SpeedTarget> speeds;
  /// Relative tolerance of each speed: what rounding of the figures leaves.
  double tolerance = 0.01;
};

/// A robot with its free values, and its published figures.
struct Question {
  dynamics::Tree tree;
  std::vector<Posture> postures;
  std::vector<FreeValue> free;
  Figures figures;
  /// In the place of the tree alone, where links of its loops weigh something.
  std::optional<Robot> with_links = {};
};

/// Returns the inertia at each target's posture with these free values; empty where a body would
/// have an inertia that no body has.
std::vector<double> inertias_kg_m2(const Question& question, std::span<const double> values);

/// Returns CAV over its target less 1, by target; empty as above.
std::vector<double> errors(const Question& question, std::span<const double> values);

}  // namespace torquewright::hopper::calibration
