// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hopper/verdict/deed.hpp"
#include "hopper/verdict/flights.hpp"
#include "hopper/verdict/standing.hpp"

namespace torquewright::hopper {

enum class ReplayVerdict {
  kStands,    ///< It did what the motion does, and stands.
  kMissed,    ///< It is up at the end and did not do what the motion does.
  kTrembles,  ///< It did it and stays up, but its feet are never at rest.
  kFell,
  kUnfinished,
  kUndecided,  ///< It ended, but an effect of a drive's document was left out.
};
std::string_view name_of(ReplayVerdict verdict);
/// Returns the verdict of that name; kUnfinished for a name of none.
ReplayVerdict verdict_named(std::string_view name);

/// Rules by which a run is judged.
struct VerdictRule {
  StandingRule standing;
  DeedTolerances deeds;
};

/// When the ground is met after a flight.
struct TouchDown {
  double time_s = 0.0;
  double planned_s = 0.0;  ///< Time in the motion.
  /// Rotation of the base that is missing against the motion's at its own touch-down; negative: it
  /// turned too far.
  double rotation_short_rad = 0.0;
};

struct ReplayOutcome {
  ReplayVerdict verdict = ReplayVerdict::kUnfinished;
  std::string reason;  ///< Reason for what is not success; empty where it did it and stands.
  double end_s = 0.0;
  double foot_at_rest_s = 0.0;  ///< Until the end.
  /// The touch-down of the motion's longest flight; none where motion or run have none.
  std::optional<TouchDown> touch_down;
  /// The touch-down of each of the motion's flights that was flown, in order.
  std::vector<TouchDown> landings;
  /// What the motion does and the run did; empty of a run that did not last to the end.
  std::vector<Deed> deeds;
};

/// Judges a run by the motion that it was to make. `robot` is that of the run, `planned` the
/// motion's flights.
ReplayOutcome outcome_of(const Robot& robot, const Reference& reference,
                         const std::vector<TimeInAir>& planned, const Record& record,
                         const VerdictRule& rule);

}  // namespace torquewright::hopper
