// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "hopper/calibration/free_value.hpp"

namespace torquewright::hopper::calibration {

/// A published average angular velocity of the whole robot at a posture.
struct SpeedTarget {
  std::size_t posture = 0;  ///< In robot.postures.
  double speed_rad_s = 0.0;
};

/// CAM is conserved in flight, so CAV = CAM over the inertia of each posture: two published
/// velocities and one momentum are two wanted inertias.
struct Figures {
  double angular_momentum_Nm_s = 0.0;
  std::vector<SpeedTarget> speeds;
  double tolerance = 0.01;  ///< Of each speed, relative: what rounding of the figures leaves.
};

/// A robot with its free values and what is published of it.
struct Question {
  dynamics::Tree tree;
  std::vector<Posture> postures;
  std::vector<FreeValue> free;
  Figures figures;
};

/// Inertia at each target's posture with these free values; empty where a body would have an
/// inertia that no body has.
std::vector<double> inertias_kg_m2(const Question& question, std::span<const double> values);

/// CAV over its target less 1, by target; empty as above.
std::vector<double> errors(const Question& question, std::span<const double> values);

}  // namespace torquewright::hopper::calibration
