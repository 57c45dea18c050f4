// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/search/plan_report_spec.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "hopper/check/hopper_report_spec.hpp"
#include "hopper/planning/search/longest_flight.hpp"
#include "hopper/replay_report/replay_report.hpp"

namespace torquewright::hopper {
namespace {

using nlohmann::ordered_json;

ordered_json or_null(double value) { return std::isfinite(value) ? ordered_json(value) : nullptr; }

ordered_json phases_json(const PlannedMotion& plan) {
  ordered_json list = ordered_json::array();
  for (const PlannedPhase& phase : plan.phases) {
    list.push_back({{"stance", phase.stance},
                    {"begin_s", phase.begin_s()},
                    {"end_s", phase.end_s()},
                    {"intervals", phase.intervals()}});
  }
  return list;
}

ordered_json objectives_json(const std::vector<ObjectivePart>& parts) {
  ordered_json list = ordered_json::array();
  for (const ObjectivePart& part : parts) {
    list.push_back({{"name", part.name},
                    {"weight", part.weight},
                    {"value", or_null(part.value)},
                    {"unit", part.unit}});
  }
  return list;
}

/// null where nothing flies.
ordered_json flight_json(const PlanResult& result) {
  const PlannedPhase* phase = longest_flight(result.plan);
  if (phase == nullptr) return nullptr;
  const auto rise_m = rise_of(result);
  return {{"from_s", phase->begin_s()},
          {"until_s", phase->end_s()},
          {"rise_m", rise_m ? or_null(*rise_m) : nullptr}};
}

ordered_json margins_json(const std::vector<LeastMargin>& margins) {
  ordered_json list = ordered_json::array();
  for (const LeastMargin& margin : margins) {
    list.push_back({{"rule", margin.rule},
                    {"place", margin.place},
                    {"time_s", or_null(margin.time_s)},
                    {"value", or_null(margin.value)},
                    {"limit", or_null(margin.limit)},
                    {"margin", or_null(margin.margin)},
                    {"unit", margin.unit}});
  }
  return list;
}

/// null where none can be told.
ordered_json or_null(const std::optional<double>& value) {
  return value ? or_null(*value) : ordered_json();
}

ordered_json prices_json(const std::vector<BoundPrice>& prices) {
  ordered_json list = ordered_json::array();
  for (const BoundPrice& part : prices) {
    list.push_back({{"name", part.name},
                    {"value", or_null(part.value)},
                    {"unit", part.unit},
                    {"per_reserve", part.per_reserve},
                    {"objective_per_unit", or_null(part.objective_per_unit)},
                    {"kept", or_null(part.kept)}});
  }
  return list;
}

ordered_json reserve_json(const PlanOptions& options, const PlanResult& result) {
  if (!(options.reserve > 0.0)) return nullptr;
  return {{"value", options.reserve},
          {"objective_per_unit", or_null(reserve_price(result.prices))}};
}

ordered_json binding_json(const std::vector<BindingConstraint>& binding) {
  ordered_json list = ordered_json::array();
  for (const BindingConstraint& one : binding) {
    list.push_back({{"name", one.name},
                    {"stance", one.stance},
                    {"instants", one.instants},
                    {"of", one.of},
                    {"from_s", one.has_times ? or_null(one.from_s) : nullptr},
                    {"until_s", one.has_times ? or_null(one.until_s) : nullptr},
                    {"violation", or_null(one.violation)},
                    {"unit", one.unit}});
  }
  return list;
}

ordered_json rounds_json(const std::vector<PlanRound>& rounds, PlanSeconds seconds) {
  ordered_json list = ordered_json::array();
  for (const PlanRound& round : rounds) {
    ordered_json& entry = list.emplace_back(
        ordered_json{{"intervals", round.intervals},
                     {"iterations", round.iterations},
                     {"solver", round.solver},
                     {"objective", or_null(round.objective)},
                     {"largest_violation", or_null(round.largest_violation)},
                     {"integration_error_rad", or_null(round.integration_error_rad)}});
    if (seconds == PlanSeconds::kLeftOut) continue;
    entry["seconds"] = or_null(round.seconds);
    entry["derivative_seconds"] = or_null(round.derivative_seconds);
  }
  return list;
}

ordered_json changes_json(const std::vector<ChangeTried>& changes) {
  ordered_json list = ordered_json::array();
  for (const ChangeTried& change : changes) {
    list.push_back({{"quantity", change.quantity},
                    {"from", or_null(change.from)},
                    {"to", or_null(change.to)},
                    {"unit", change.unit},
                    {"has_plan", change.has_plan},
                    {"cut_off", change.is_cut_off}});
  }
  return list;
}

ordered_json check_json(const PlanResult& result) {
  return result.check ? hopper_report_json(*result.check) : ordered_json();
}

/// Of a flight; null where nothing flies.
ordered_json in_flight(const PlanResult& result, double value) {
  return longest_flight(result.plan) == nullptr ? ordered_json() : or_null(value);
}

}  // namespace

ordered_json plan_report_json(const PlanOptions& options, const PlanResult& result,
                              PlanSeconds seconds) {
  return {{"kind", "plan_report"},
          {"version", 1},
          {"status", name_of(result.status)},
          {"reason", result.reason},
          {"task", options.task->name},
          {"limits", name_of(options.limits)},
          {"objective", or_null(result.objective)},
          {"iterations", result.iterations},
          {"largest_violation", or_null(result.largest_violation)},
          {"integration_error_rad", or_null(result.integration_error_rad)},
          {"cam_kg_m2_s", in_flight(result, result.angular_momentum_Nm_s)},
          {"cav_take_off_rad_s", in_flight(result, result.take_off_rad_s)},
          {"cav_peak_rad_s", in_flight(result, result.peak_rad_s)},
          {"check", check_json(result)},
          {"least_margins", margins_json(result.least_margins)},
          {"prices", prices_json(result.prices)},
          {"reserve", reserve_json(options, result)},
          {"binding", binding_json(result.binding)},
          {"phases", phases_json(result.plan)},
          {"flight", flight_json(result)},
          {"objectives", objectives_json(result.objectives)},
          {"rounds", rounds_json(result.rounds, seconds)},
          {"changes", changes_json(result.changes)}};
}

}  // namespace torquewright::hopper
