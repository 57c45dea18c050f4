// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "hopper/record/record.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Limits by which a robot counts as standing, at the end of the time that it is watched.
struct StandingRule {
  double at_rest_s = 0.5;        ///< So long at least its feet have been at rest,
  double foot_speed_m_s = 0.02;  ///< slower than this where the ground presses on them,
  double body_speed_m_s = 0.1;   ///< its centre of mass is no faster than this,
  double lean_rad = 0.5;  ///< and its base leans no farther from how it stands at the motion's end.
};

/// Returns for how long, until the end, the feet have touched the ground at rest, in s.
double foot_at_rest_s(const Record& record, const StandingRule& rule);

/// Returns why a robot that was watched to the end does not stand, as a sentence; empty: it does.
/// Requires a record with rows.
std::string objection_to_standing(const Robot& robot, const Reference& reference,
                                  const Record& record, const StandingRule& rule);

/// Returns whether a robot that does not stand still stays up all the same: over the rule's time
/// until the end its base leans no farther, its feet never leave the ground for as long as a
/// flight, and on average feet and centre of mass drift no faster than the rule allows. It
/// trembles, as a regulator does that feeds back noise.
bool stays_up(const Robot& robot, const Reference& reference, const Record& record,
              const StandingRule& rule);

}  // namespace torquewright::hopper
