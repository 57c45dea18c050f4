// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "hopper/replay/record.hpp"

namespace torquewright::hopper {

enum class ReplayVerdict {
  kStands,
  kFell,
  kUnfinished,
  kUndecided,  ///< It ended, but an effect of a drive's document was left out.
};
std::string_view name_of(ReplayVerdict verdict);

/// Limits by which a robot counts as standing, at the end of the time that it is watched.
struct StandingRule {
  double at_rest_s = 0.5;        ///< So long at least its feet have been at rest,
  double foot_speed_m_s = 0.02;  ///< slower than this where the ground presses on them,
  double body_speed_m_s = 0.1;   ///< its centre of mass is no faster than this,
  double tilt_rad = 0.5;         ///< and its base stands no farther from the motion's last posture.
};

/// When the ground is met after the longest flight.
struct TouchDown {
  double time_s = 0.0;
  double planned_s = 0.0;  ///< Time in the motion.
  /// Rotation of the base that is missing against the motion's at its own touch-down; negative: it
  /// turned too far.
  double rotation_short_rad = 0.0;
};

struct ReplayOutcome {
  ReplayVerdict verdict = ReplayVerdict::kUnfinished;
  std::string reason;  ///< Reason for a fall or for an unfinished run; empty where it stands.
  double end_s = 0.0;
  double foot_at_rest_s = 0.0;  ///< Until the end.
  /// The touch-down; none where motion or run have no flight.
  std::optional<TouchDown> touch_down;
};

/// `robot` is that of the run.
ReplayOutcome outcome_of(const Robot& robot, const Reference& reference, const Record& record,
                         const StandingRule& rule);

}  // namespace torquewright::hopper
