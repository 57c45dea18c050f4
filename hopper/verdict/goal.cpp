// SPDX-License-Identifier: Apache-2.0
#include "hopper/verdict/goal.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "hopper/motion/landing.hpp"
#include "hopper/verdict/turn.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

/// Losses of contact that count, those with which a run ends among them.
std::vector<TimeInAir> flights_flown(const Record& record) {
  std::vector<TimeInAir> flights = losses_of_contact(record);
  std::erase_if(flights, [](const TimeInAir& one) { return one.duration_s() < kCountedFlight_s; });
  return flights;
}

double turned_about_y_rad(const Robot& robot, const Record& record, double until_s) {
  return turned_rad(robot.tree, record, until_s).y();
}

Deed rotation_deed(const Robot& robot, const Goal& goal, const Record& record,
                   const DeedTolerances& tolerances) {
  Deed deed;
  deed.name = "rotation";
  deed.unit = "rad";
  deed.planned = goal.turn_rad;
  deed.done = turned_about_y_rad(robot, record, record.end_s);
  deed.off = std::abs(deed.done - deed.planned);
  deed.tolerance = tolerances.turn_rad;
  deed.is_done = deed.off <= deed.tolerance;
  deed.sentence = fmt::format("the base turns by {:.1f} of {:.1f} degrees", kDegrees * deed.done,
                              kDegrees * deed.planned);
  return deed;
}

Deed flights_deed(const Goal& goal, std::size_t flown) {
  Deed deed;
  deed.name = "flights";
  deed.unit = "1";
  deed.done = static_cast<double>(flown);
  deed.planned = std::clamp<double>(deed.done, goal.least_flights, goal.most_flights);
  deed.off = std::abs(deed.done - deed.planned);
  deed.is_done = deed.off == 0.0;
  const std::string times = deed.done == 1.0 ? "once" : fmt::format("{:g} times", deed.done);
  deed.sentence = deed.is_done
                      ? fmt::format("it flies {}, as the task allows", times)
                      : fmt::format("it flies {} in the place of {:g}", times, deed.planned);
  return deed;
}

Deed forward_deed(const Goal& goal, const Record& record) {
  const RecordRow& first = record.rows.front();
  const RecordRow& last = record.rows.back();
  Deed deed;
  deed.name = "forward_velocity";
  deed.unit = "m/s";
  deed.planned = *goal.forward_m_s;
  const double time_s = last.time_s - first.time_s;
  deed.done = time_s > 0.0 ? (last.position[0] - first.position[0]) / time_s : 0.0;
  deed.off = std::abs(deed.done - deed.planned);
  deed.tolerance = goal.forward_tolerance_m_s;
  deed.is_done = deed.off <= deed.tolerance;
  deed.sentence =
      fmt::format("it goes at {:.2f} m/s in the place of {:.2f}", deed.done, deed.planned);
  return deed;
}

/// Of hops, from landing to landing.
Deed hopping_deed(const Robot& robot, const Goal& goal, const Record& record,
                  const std::vector<TimeInAir>& flights, const DeedTolerances& tolerances) {
  std::vector<Landing> landings;
  for (const RecordRow& row : record.rows) {
    if (landings.size() == flights.size()) break;
    if (row.time_s < flights[landings.size()].until_s) continue;
    landings.push_back(landing_at(robot.tree, row.time_s, row.position));
  }
  double way_m = 0.0;
  for (std::size_t i = 1; i < landings.size(); ++i) way_m += hopped_m(landings[i - 1], landings[i]);
  Deed deed;
  deed.name = "hopping_speed";
  deed.unit = "m/s";
  deed.planned = *goal.forward_m_s;
  deed.done =
      landings.size() < 2 ? 0.0 : way_m / (landings.back().time_s - landings.front().time_s);
  deed.off = std::abs(deed.done - deed.planned);
  deed.tolerance = tolerances.speed_m_s;
  deed.is_done = deed.off <= deed.tolerance;
  deed.sentence =
      fmt::format("it hops at {:.3f} m/s in the place of {:.3f}", deed.done, deed.planned);
  return deed;
}

/// How far a run's robot faces at its end from where it is to, about the vertical.
double faces_off_rad(const Robot& robot, const Reference& ends, const Record& record) {
  ReferenceInstant last;
  ends.at(ends.ends_s(), last);
  const Eigen::Vector2d to = landing_at(robot.tree, 0.0, last.position).forward;
  const Eigen::Vector2d is = landing_at(robot.tree, 0.0, record.rows.back().position).forward;
  return std::atan2(to.x() * is.y() - to.y() * is.x(), to.dot(is));
}

/// Hops hold no heading: whichever it is, it is said.
Deed heading_deed(double off_rad) {
  Deed deed;
  deed.name = "heading";
  deed.unit = "rad";
  deed.done = off_rad;
  deed.off = std::abs(off_rad);
  deed.tolerance = std::numbers::pi;
  deed.sentence = fmt::format("it faces {:.0f} degrees from where it is to, as it may",
                              std::round(kDegrees * off_rad) + 0.0);
  return deed;
}

/// The end of a run by which standing is judged, turned about the vertical.
Record turned_end(const Robot& robot, const Record& record, double turn_rad, double lasts_s) {
  Record end;
  end.end = record.end;
  end.end_s = record.end_s;
  const Eigen::AngleAxisd turn(turn_rad, Eigen::Vector3d::UnitZ());
  for (const RecordRow& row : record.rows) {
    if (row.time_s < record.end_s - lasts_s) continue;
    RecordRow& turned = end.rows.emplace_back(row);
    if (robot.tree.base != dynamics::BaseKind::kSpatial) continue;
    const Eigen::Quaterniond attitude(row.position[3], row.position[4], row.position[5],
                                      row.position[6]);
    const Eigen::Quaterniond there = turn * attitude;
    turned.position.head<3>() = turn * row.position.head<3>();
    turned.position.segment<4>(3) << there.w(), there.x(), there.y(), there.z();
    turned.velocity.head<3>() = turn * row.velocity.head<3>();
  }
  return end;
}

/// What keeps a robot that does not rest from counting as up; empty: it is.
std::string objection_to_staying_up(const Robot& robot, const Reference& ends, const Record& record,
                                    const StandingRule& rule) {
  ReferenceInstant goal;
  ends.at(ends.ends_s(), goal);
  const Eigen::Matrix3d off = base_attitude(robot.tree, goal.position).transpose() *
                              base_attitude(robot.tree, record.rows.back().position);
  const double tilt_rad = Eigen::AngleAxisd(off).angle();
  if (tilt_rad <= rule.tilt_rad) return "";
  return fmt::format("at the end its base is {:.0f} degrees from the attitude that it began in",
                     kDegrees * tilt_rad);
}

void note_landings(const Robot& robot, const Goal& goal, const Record& record,
                   const std::vector<TimeInAir>& flights, ReplayOutcome& outcome) {
  for (std::size_t i = 0; i < flights.size(); ++i) {
    const double until_s = flights[i].until_s;
    const double planned_s = i < goal.landings_s.size() ? goal.landings_s[i] : goal.landing_s;
    outcome.landings.push_back(
        {until_s, planned_s, goal.turn_rad - turned_about_y_rad(robot, record, until_s)});
  }
  if (!outcome.landings.empty()) outcome.touch_down = outcome.landings.front();
}

void judge_deeds(const std::string& objection, ReplayOutcome& outcome) {
  std::string missing;
  for (const Deed& deed : outcome.deeds) {
    if (!deed.is_done) missing += (missing.empty() ? "" : "; ") + deed.sentence;
  }
  if (!missing.empty()) {
    outcome.verdict = ReplayVerdict::kMissed;
    outcome.reason = fmt::format("it {}, but did not do the task: {}",
                                 objection.empty() ? "stands" : "stays up", missing);
  } else {
    outcome.verdict = objection.empty() ? ReplayVerdict::kStands : ReplayVerdict::kTrembles;
    outcome.reason = objection.empty() ? "" : "it stays up, trembling: " + objection;
  }
}

}  // namespace

namespace {

/// On a robot that is to rest at the end; `end` holds how the run ends at least.
void judge_rest(const Robot& robot, const Reference& ends, const Record& end,
                const VerdictRule& rule, ReplayOutcome& outcome) {
  outcome.reason = objection_to_standing(robot, ends, end, rule.standing);
  const bool is_up = outcome.reason.empty() || stays_up(robot, ends, end, rule.standing);
  const std::string objection = outcome.reason;
  if (is_up) judge_deeds(objection, outcome);
}

}  // namespace

ReplayOutcome outcome_of(const Robot& robot, const Reference& ends, const Goal& goal,
                         const Record& record, const VerdictRule& rule) {
  ReplayOutcome outcome;
  outcome.end_s = record.end_s;
  outcome.reason = record.reason;
  if (record.rows.empty()) return outcome;
  const std::vector<TimeInAir> flights = flights_flown(record);
  note_landings(robot, goal, record, flights, outcome);
  outcome.foot_at_rest_s = foot_at_rest_s(record, rule.standing);
  if (record.end == RunEnd::kStopped || record.end == RunEnd::kAsked) return outcome;
  outcome.deeds.push_back(rotation_deed(robot, goal, record, rule.deeds));
  outcome.deeds.push_back(flights_deed(goal, flights.size()));
  if (goal.forward_m_s) {
    outcome.deeds.push_back(goal.landings_s.empty()
                                ? forward_deed(goal, record)
                                : hopping_deed(robot, goal, record, flights, rule.deeds));
  }
  outcome.verdict = ReplayVerdict::kFell;
  if (record.end == RunEnd::kFell) return outcome;
  if (!goal.rests) {
    outcome.reason = objection_to_staying_up(robot, ends, record, rule.standing);
    if (outcome.reason.empty()) judge_deeds("", outcome);
    return outcome;
  }
  if (goal.landings_s.empty()) {
    judge_rest(robot, ends, record, rule, outcome);
    return outcome;
  }
  const double off_rad = faces_off_rad(robot, ends, record);
  outcome.deeds.push_back(heading_deed(off_rad));
  const Record end = turned_end(robot, record, -off_rad, 2.0 * rule.standing.at_rest_s);
  judge_rest(robot, ends, end, rule, outcome);
  return outcome;
}

}  // namespace torquewright::hopper
