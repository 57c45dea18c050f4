// SPDX-License-Identifier: Apache-2.0
#include "hopper/verdict/standing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "hopper/verdict/flights.hpp"
#include "hopper/verdict/ground_place.hpp"
#include "hopper/verdict/turn.hpp"
#include "robot/model/robot_centroid.hpp"

namespace torquewright::hopper {
namespace {

dynamics::Centroid centroid_of(const Robot& robot, const RecordRow& row) {
  return RobotCentroid(robot).at(row.position, row.velocity);
}

double lean_rad(const Robot& robot, const Reference& reference, const RecordRow& row) {
  ReferenceInstant goal;
  reference.at(reference.ends_s(), goal);
  return attitude_error(robot.tree, goal.position, row.position).lean_rad;
}

/// Whether feet and centre of mass get from one row to the other no faster than the rule allows.
bool drifts_within(const Robot& robot, const Reference& reference, const RecordRow& first,
                   const RecordRow& last, const StandingRule& rule) {
  const double time_s = last.time_s - first.time_s;
  const TouchingPoints& feet = reference.modes().back().touches;
  const double foot_m =
      (ground_place_m(robot, feet, last.position) - ground_place_m(robot, feet, first.position))
          .norm();
  const double body_m =
      (centroid_of(robot, last).position_m - centroid_of(robot, first).position_m).norm();
  return foot_m <= rule.foot_speed_m_s * time_s && body_m <= rule.body_speed_m_s * time_s;
}

}  // namespace

double foot_at_rest_s(const Record& record, const StandingRule& rule) {
  double since_s = record.end_s;
  for (auto row = record.rows.rbegin(); row != record.rows.rend(); ++row) {
    if (!row->touches.any() || row->slip_m_s > rule.foot_speed_m_s) break;
    since_s = row->time_s;
  }
  return record.end_s - since_s;
}

std::string objection_to_standing(const Robot& robot, const Reference& reference,
                                  const Record& record, const StandingRule& rule) {
  const RecordRow& last = record.rows.back();
  if (last.touches.size() > 0 && !last.touches.any()) {
    return "at the end of the time that it is watched, no foot touches the ground";
  }
  const double at_rest_s = foot_at_rest_s(record, rule);
  if (at_rest_s < rule.at_rest_s) {
    return fmt::format(
        "at the end of the time that it is watched, its feet are at rest for {:.3g} s only, where "
        "standing takes {:.3g} s",
        at_rest_s, rule.at_rest_s);
  }
  const double speed_m_s = centroid_of(robot, last).velocity_m_s.norm();
  if (speed_m_s > rule.body_speed_m_s) {
    return fmt::format("its feet are at rest, but its centre of mass still moves at {:.3g} m/s",
                       speed_m_s);
  }
  const double off_rad = lean_rad(robot, reference, last);
  if (off_rad > rule.lean_rad) {
    return fmt::format(
        "it came to rest with its base leaning {:.0f} degrees from how the motion ends",
        off_rad * 180.0 / std::numbers::pi);
  }
  return "";
}

bool stays_up(const Robot& robot, const Reference& reference, const Record& record,
              const StandingRule& rule) {
  const double from_s = record.end_s - rule.at_rest_s;
  if (from_s < reference.ends_s()) return false;
  const auto first = std::find_if(record.rows.begin(), record.rows.end(),
                                  [from_s](const RecordRow& row) { return row.time_s >= from_s; });
  if (first == record.rows.end()) return false;
  double last_contact_s = first->time_s;
  for (auto row = first; row != record.rows.end(); ++row) {
    if (lean_rad(robot, reference, *row) > rule.lean_rad) return false;
    if (row->touches.any()) last_contact_s = row->time_s;
    if (row->time_s - last_contact_s >= kShortestFlight_s) return false;
  }
  return drifts_within(robot, reference, *first, record.rows.back(), rule);
}

}  // namespace torquewright::hopper
