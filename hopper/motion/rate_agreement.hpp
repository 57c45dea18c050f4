// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hopper/motion/motion.hpp"
#include "io/faults/spec_error.hpp"

namespace torquewright::hopper {

/// A coordinate whose given rate is not the derivative of the quantity it belongs to.
struct RateMismatch {
  std::string coordinate;
  /// Whether it is an acceleration that is held against its velocity; else a velocity against its
  /// position.
  bool is_acceleration = false;
  double from_s = 0.0;  ///< Time of the first stretch that disagrees.
  double until_s = 0.0;
  /// Share of disagreeing stretches among those in which the coordinate moves.
  double share = 0.0;
  double given_rms = 0.0;  ///< Rms of the given rate over all stretches.
  double slope_rms = 0.0;  ///< Rms of the rate that the change of the other table makes.
  double difference_rms = 0.0;
  double factor = 1.0;       ///< Given rate over that rate, by least squares.
  double correlation = 0.0;  ///< Squared correlation of both rates.
  std::string likely_cause;
};

/// Compares what the file gives of positions, velocities and accelerations over stretches of ten
/// samples: mean rate against change over duration, not across impacts. A stretch disagrees where
/// they differ by more than shares of the larger one and of the coordinate's rms, and by more than
/// their noise and a step of rounding; a
/// coordinate where more than a quarter of the stretches do. Coordinates that hardly move beside
/// others of their kind are not asked. docs/derivations/whole_body_check.md, "What breaks physics".
std::vector<RateMismatch> rate_mismatches(const Robot& robot, const Motion& motion);

/// Throws io::SpecError with interval, size and likely cause where there is a mismatch.
void require_rates_agree(const Robot& robot, const Motion& motion);

}  // namespace torquewright::hopper
