// SPDX-License-Identifier: Apache-2.0
#include "hopper/verdict/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "hopper/verdict/every_deed.hpp"
#include "hopper/verdict/turn.hpp"

namespace torquewright::hopper {
namespace {

constexpr std::array<std::pair<ReplayVerdict, std::string_view>, 6> kNames{
    {{ReplayVerdict::kStands, "stands"},
     {ReplayVerdict::kMissed, "missed"},
     {ReplayVerdict::kTrembles, "trembles"},
     {ReplayVerdict::kFell, "fell"},
     {ReplayVerdict::kUnfinished, "unfinished"},
     {ReplayVerdict::kUndecided, "undecided"}}};

constexpr std::size_t kMostNamedDeeds = 3;

TouchDown touch_down_of(const Robot& robot, const Reference& reference, const Record& record,
                        const MatchedFlight& flight) {
  const Eigen::Vector3d plan_rad =
      planned_turn_rad(robot.tree, reference, record.control_period_s, flight.planned.until_s);
  const Eigen::Vector3d run_rad = turned_rad(robot.tree, record, flight.flown->until_s);
  return {flight.flown->until_s, flight.planned.until_s,
          axis_of_turn(plan_rad).dot(plan_rad - run_rad)};
}

void note_landings(const Robot& robot, const Reference& reference,
                   const std::vector<TimeInAir>& planned, const Record& record,
                   ReplayOutcome& outcome) {
  double longest_s = 0.0;
  for (const MatchedFlight& flight : matched_flights(planned, reference.begins_s(), record)) {
    const bool is_longest = flight.planned.duration_s() > longest_s;
    longest_s = std::max(longest_s, flight.planned.duration_s());
    if (is_longest) outcome.touch_down.reset();
    if (!flight.has_flown()) continue;
    outcome.landings.push_back(touch_down_of(robot, reference, record, flight));
    if (is_longest) outcome.touch_down = outcome.landings.back();
  }
}

std::vector<Deed> deeds_of(const Attempt& attempt) {
  std::vector<Deed> deeds;
  for (const DeedKind& kind : kEveryDeed) {
    for (Deed& deed : kind(attempt)) deeds.push_back(std::move(deed));
  }
  return deeds;
}

/// What was not done, in words; empty: all was.
std::string missing_words(const std::vector<Deed>& deeds) {
  std::string words;
  std::size_t missing = 0;
  for (const Deed& deed : deeds) {
    if (deed.is_done || ++missing > kMostNamedDeeds) continue;
    words += (words.empty() ? "" : "; ") + deed.sentence;
  }
  if (missing > kMostNamedDeeds) words += fmt::format("; and {} more", missing - kMostNamedDeeds);
  return words;
}

/// The verdict on a robot that is up at the end.
void judge_deeds(const Attempt& attempt, const std::string& objection, ReplayOutcome& outcome) {
  outcome.deeds = deeds_of(attempt);
  const std::string missing = missing_words(outcome.deeds);
  if (!missing.empty()) {
    outcome.verdict = ReplayVerdict::kMissed;
    outcome.reason = fmt::format("it {}, but did not do the motion: {}",
                                 objection.empty() ? "stands" : "stays up", missing);
  } else {
    outcome.verdict = objection.empty() ? ReplayVerdict::kStands : ReplayVerdict::kTrembles;
    outcome.reason = objection.empty() ? "" : "it stays up, trembling: " + objection;
  }
}

}  // namespace

std::string_view name_of(ReplayVerdict verdict) {
  return std::find_if(kNames.begin(), kNames.end(),
                      [verdict](const auto& one) { return one.first == verdict; })
      ->second;
}

ReplayVerdict verdict_named(std::string_view name) {
  const auto found = std::find_if(kNames.begin(), kNames.end(),
                                  [name](const auto& one) { return one.second == name; });
  return found == kNames.end() ? ReplayVerdict::kUnfinished : found->first;
}

ReplayOutcome outcome_of(const Robot& robot, const Reference& reference,
                         const std::vector<TimeInAir>& planned, const Record& record,
                         const VerdictRule& rule) {
  ReplayOutcome outcome;
  outcome.end_s = record.end_s;
  outcome.reason = record.reason;
  if (record.rows.empty()) return outcome;
  note_landings(robot, reference, planned, record, outcome);
  outcome.foot_at_rest_s = foot_at_rest_s(record, rule.standing);
  if (record.end == RunEnd::kStopped || record.end == RunEnd::kAsked) return outcome;
  outcome.verdict = ReplayVerdict::kFell;
  if (record.end == RunEnd::kFell) return outcome;
  outcome.reason = objection_to_standing(robot, reference, record, rule.standing);
  const bool is_up = outcome.reason.empty() || stays_up(robot, reference, record, rule.standing);
  if (!is_up) return outcome;
  const std::string objection = outcome.reason;
  judge_deeds(Attempt(robot, reference, planned, record, rule.deeds), objection, outcome);
  return outcome;
}

}  // namespace torquewright::hopper
