// SPDX-License-Identifier: Apache-2.0
#include "hopper/verdict/goal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hopper/motion/landing.hpp"
#include "hopper/verdict/heading_deed.hpp"
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

/// Hops at a commanded speed hold no heading: whichever it is, it is said.
Deed end_heading_deed(const Robot& robot, const Goal& goal, const Reference& ends,
                      const Record& record, const DeedTolerances& tolerances) {
  ReferenceInstant last;
  ends.at(ends.ends_s(), last);
  const double tolerance_rad = goal.landings_s.empty() ? tolerances.heading_rad : std::numbers::pi;
  return heading_deed(robot.tree, last.position, record.rows.back().position, tolerance_rad);
}

/// What keeps a robot that does not rest from counting as up; empty: it is.
std::string objection_to_staying_up(const Robot& robot, const Reference& ends, const Record& record,
                                    const StandingRule& rule) {
  ReferenceInstant goal;
  ends.at(ends.ends_s(), goal);
  const double lean_rad =
      attitude_error(robot.tree, goal.position, record.rows.back().position).lean_rad;
  if (lean_rad <= rule.lean_rad) return "";
  return fmt::format("at the end its base leans {:.0f} degrees from how it began",
                     kDegrees * lean_rad);
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

/// On a robot that is to rest at the end.
void judge_rest(const Robot& robot, const Reference& ends, const Record& record,
                const VerdictRule& rule, ReplayOutcome& outcome) {
  outcome.reason = objection_to_standing(robot, ends, record, rule.standing);
  const bool is_up = outcome.reason.empty() || stays_up(robot, ends, record, rule.standing);
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
  if (robot.tree.base == dynamics::BaseKind::kSpatial) {
    outcome.deeds.push_back(end_heading_deed(robot, goal, ends, record, rule.deeds));
  }
  outcome.verdict = ReplayVerdict::kFell;
  if (record.end == RunEnd::kFell) return outcome;
  if (!goal.rests) {
    outcome.reason = objection_to_staying_up(robot, ends, record, rule.standing);
    if (outcome.reason.empty()) judge_deeds("", outcome);
    return outcome;
  }
  judge_rest(robot, ends, record, rule, outcome);
  return outcome;
}

}  // namespace torquewright::hopper
