// SPDX-License-Identifier: Apache-2.0
#include "src/commands/planning/hopper_flip_row.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "hopper/planning/search/longest_flight.hpp"
#include "hopper/trials/success_rate.hpp"
#include "src/commands/robot/hopper_check_row.hpp"

namespace torquewright::cli {
namespace {

using hopper::PlanResult;
using hopper::PlanStatus;

/// As the exit codes of one plan have it.
sweep::RowVerdict verdict_of(PlanStatus status) {
  switch (status) {
    case PlanStatus::kPlanned:
      return sweep::RowVerdict::kPasses;
    case PlanStatus::kLocallyInfeasible:
      return sweep::RowVerdict::kFails;
    default:
      return sweep::RowVerdict::kOpen;
  }
}

/// A motion that the check does not pass is told from a search that had no time.
std::string word_of(PlanStatus status) {
  if (status == PlanStatus::kCheckFails) return "check_fails";
  return std::string(hopper::name_of(status));
}

std::optional<double> measure(const sweep::SweepRow& row, const std::string& name) {
  const auto found =
      std::find_if(row.measures.begin(), row.measures.end(),
                   [&](const sweep::Measure& measure) { return measure.name == name; });
  return found != row.measures.end() ? found->value : std::nullopt;
}

/// Of trials that are done, how many succeeded, and between which shares the chance lies.
std::vector<sweep::Measure> success_of(const std::optional<hopper::TrialOutcomes>& outcomes) {
  if (!outcomes) return {{"success_share", {}}, {"success_least", {}}, {"success_most", {}}};
  const hopper::TrialCounts counts = hopper::counted(*outcomes);
  const hopper::ShareInterval interval = hopper::success_interval(counts);
  std::optional<double> share;
  if (counts.done() > 0) {
    share = static_cast<double>(counts.succeeded) / static_cast<double>(counts.done());
  }
  return {{"success_share", share},
          {"success_least", interval.least},
          {"success_most", interval.greatest}};
}

/// What became of the trials that did not succeed, the verdicts in their own words.
std::string failures_of(const hopper::TrialOutcomes& outcomes) {
  std::map<std::string_view, std::size_t> counts;
  for (const auto& outcome : outcomes) {
    if (outcome && outcome->verdict == hopper::ReplayVerdict::kStands) continue;
    ++counts[name_of(outcome ? outcome->verdict : hopper::ReplayVerdict::kUnfinished)];
  }
  std::string text;
  for (const auto& [verdict, count] : counts) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, verdict);
  }
  return text.empty() ? text : fmt::format("of {} trials {}", outcomes.size(), text);
}

std::vector<sweep::Measure> measures_of(const PlanResult& result, const sweep::SweepRow& checked) {
  const hopper::PlannedPhase* flight = hopper::longest_flight(result.plan);
  const bool is_plan = result.status == PlanStatus::kPlanned;
  const auto in_flight = [&](double value) {
    return is_plan && flight != nullptr ? std::optional(value) : std::nullopt;
  };
  const auto of_check = [&](const char* name) {
    return sweep::Measure{name, is_plan ? measure(checked, name) : std::nullopt};
  };
  return {of_check("margin_share"),
          of_check("margin_Nm"),
          {"objective", is_plan ? std::optional(result.objective) : std::nullopt},
          {"cam_kg_m2_s", in_flight(result.angular_momentum_Nm_s)},
          {"cav_take_off_rad_s", in_flight(result.take_off_rad_s)},
          {"cav_peak_rad_s", in_flight(result.peak_rad_s)},
          {"flight_s", in_flight(flight != nullptr ? flight->end_s() - flight->begin_s() : 0.0)},
          of_check("gear_load_share"),
          of_check("least_bus_V")};
}

/// What holds the search back most often: of what is violated, where something is.
std::string binding_of(const PlanResult& result) {
  if (result.binding.empty()) return "";
  const auto violated =
      std::find_if(result.binding.begin(), result.binding.end(),
                   [](const hopper::BindingConstraint& one) { return one.violation > 0.0; });
  const hopper::BindingConstraint& most =
      violated == result.binding.end() ? result.binding.front() : *violated;
  return fmt::format("{} ({})", most.name, most.stance);
}

}  // namespace

sweep::SweepRow hopper_flip_row(const hopper::Robot& robot, const hopper::CheckOptions& check,
                                const PlanResult& result) {
  sweep::SweepRow checked;
  if (result.check) checked = hopper_check_row(robot, check, *result.check);
  sweep::SweepRow row;
  row.verdict = verdict_of(result.status);
  row.status = word_of(result.status);
  row.measures = measures_of(result, checked);
  row.why = result.reason;
  row.binding = result.status == PlanStatus::kPlanned ? checked.binding : binding_of(result);
  return row;
}

void add_trials(const std::optional<hopper::TrialOutcomes>& outcomes, sweep::SweepRow& row) {
  const std::vector<sweep::Measure> success = success_of(outcomes);
  row.measures.insert(row.measures.begin(), success.begin(), success.end());
  if (outcomes) row.why = failures_of(*outcomes);
}

}  // namespace torquewright::cli
