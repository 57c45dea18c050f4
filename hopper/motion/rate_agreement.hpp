// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hopper/motion/motion.hpp"
#include "io/faults/spec_error.hpp"

namespace torquewright::hopper {

/// A coordinate whose given rate is not the rate of what it is said to be the rate of.
struct RateMismatch {
  std::string coordinate;
  bool is_acceleration = false;  ///< Of a velocity; else a velocity of a position.
  double from_s = 0.0;           ///< The first and the last stretch that disagree.
  double until_s = 0.0;
  double share = 0.0;      ///< Of the stretches in which it moves: those that disagree.
  double given_rms = 0.0;  ///< Over all stretches,
  double slope_rms = 0.0;  ///< as the change of the other table makes it,
  double difference_rms = 0.0;
  double factor = 1.0;       ///< Given over slope, least squares.
  double correlation = 0.0;  ///< Of the two, squared.
  std::string likely_cause;
};

/// Compares what the file gives of positions, velocities and accelerations over stretches of ten
/// samples: mean rate against change over duration, not across impacts. A stretch disagrees where
/// they differ by more than shares of the larger one and of the coordinate's rms, and by more than
/// their noise; a coordinate where more than a quarter of the stretches do. Coordinates that hardly
/// move beside others of their kind are not asked. docs/derivations/whole_body_check.md, "What
/// breaks physics".
std::vector<RateMismatch> rate_mismatches(const Robot& robot, const Motion& motion);

/// Throws io::SpecError with interval, size and likely cause where there is one.
void require_rates_agree(const Robot& robot, const Motion& motion);

}  // namespace torquewright::hopper
