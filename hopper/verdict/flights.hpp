// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "hopper/demand/flights.hpp"
#include "hopper/record/record.hpp"

namespace torquewright::hopper {

/// A shorter loss of contact is chatter, and no flight of a motion.
inline constexpr double kShortestFlight_s = 0.01;

/// A stretch of time without any contact.
struct TimeInAir {
  double from_s = 0.0;
  double until_s = 0.0;

  double duration_s() const { return until_s - from_s; }
};

/// Returns the motion's flights of at least kShortestFlight_s that end with a contact, in order, by
/// its contact modes.
std::vector<TimeInAir> flights_of(const Reference& reference);

/// Returns them with the take-offs of its check: where heights alone say what touches, a mode ends
/// when the foot is seen to rise, and the flight began when the ground's force ended.
std::vector<TimeInAir> flights_of(const Reference& reference, const std::vector<Flight>& checked);

/// Returns every loss of contact of a run that ends with one, however short, in order. Of a robot
/// that begins in the air, the first begins with the record.
std::vector<TimeInAir> losses_of_contact(const Record& record);

/// A flight of the motion and what the run made of it.
struct MatchedFlight {
  TimeInAir planned;
  bool begins_in_motion = true;    ///< Whether the motion holds its take-off.
  std::optional<TimeInAir> flown;  ///< None where nothing in the run comes near it.

  /// Whether the run flew and did not only lose contact for a moment.
  bool has_flown() const { return flown && flown->duration_s() >= kShortestFlight_s; }
};

/// Returns each of the motion's flights with the run's that is most like it: of all assignments
/// that keep the order, the one whose beginnings and ends are least apart in sum. A flight that
/// would be farther apart than twice the planned one is long counts as not flown.
/// `begins_s` is the motion's begin.
std::vector<MatchedFlight> matched_flights(const std::vector<TimeInAir>& planned, double begins_s,
                                           const Record& record);

}  // namespace torquewright::hopper
