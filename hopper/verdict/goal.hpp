// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "hopper/verdict/verdict.hpp"

namespace torquewright::hopper {

/// What a run is to do where no motion says it, of a policy that follows none.
struct Goal {
  double turn_rad = 0.0;   ///< How far the base turns about +y, whole turns included.
  int least_flights = 0;   ///< How often it flies, at least,
  int most_flights = 0;    ///< and at most.
  double landing_s = 0.0;  ///< When it comes down, as far as that is said; for the report alone.
  bool rests = true;       ///< Whether its feet rest at the end, else it only stays up.
  std::optional<double> forward_m_s;  ///< Mean velocity of the base along the world's x.
  double forward_tolerance_m_s = 0.3;
  /// Of hops, when each is to land: the velocity is then that from the first landing to the last,
  /// hop by hop along the way that the base faces. Empty: of all that the run lasts.
  std::vector<double> landings_s;
};

/// A shorter loss of contact is no flight of a goal: feet that chatter are not counted.
inline constexpr double kCountedFlight_s = 0.1;

/// Judges a run by a goal. `ends` is a reference that begins where the run does and ends in the
/// base's attitude that the goal has; of its joints nothing is asked. Requires the robot of the
/// run.
ReplayOutcome outcome_of(const Robot& robot, const Reference& ends, const Goal& goal,
                         const Record& record, const VerdictRule& rule);

}  // namespace torquewright::hopper
