// SPDX-License-Identifier: Apache-2.0
#include "src/report/motion/flip_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "hopper/planning/search/longest_flight.hpp"

namespace torquewright::report {

using namespace hopper;

namespace {

std::string with_unit(double value, const std::string& unit) {
  constexpr double kRounding = 1e-5;  // In any unit of a plan: what a solver leaves of a zero.
  const double shown = std::abs(value) < kRounding ? 0.0 : value;
  return fmt::format("{:.4g}{}{}", shown, unit.empty() ? "" : " ", unit);
}

constexpr double kMore = 0.01;  // of a share, a radian or a second, by which prices are told

/// What that much more costs.
std::string more_words(const std::optional<double>& per_unit, const std::string& more) {
  if (!per_unit) return "what more of it costs cannot be told";
  return fmt::format("{} more: objective {:+.3g}", more, kMore * *per_unit);
}

}  // namespace

std::string verdict_words(const PlanOptions& options, const PlanResult& result) {
  switch (result.status) {
    case PlanStatus::kPlanned: {
      const bool is_box = options.limits == DriveLimits::kBox;
      const bool passes = result.check && result.check->check.verdict == actuator::Verdict::kPass;
      return fmt::format("planned: the {} keeps to the {} of all drives and to the contacts{}",
                         options.task->name, is_box ? "boxes of torque and speed" : "regions",
                         passes   ? "; `hopper check` passes it"
                         : is_box ? "; `hopper check` holds it against the regions and fails it"
                                  : "");
    }
    case PlanStatus::kLocallyInfeasible:
      return fmt::format("locally infeasible: {}",
                         result.reason.empty() ? "no plan was found" : result.reason);
    case PlanStatus::kCheckFails:
      return fmt::format("undecided: {}", result.reason);
    default:
      return fmt::format("limit: {}",
                         result.reason.empty() ? "the search was ended" : result.reason);
  }
}

std::string proof_words(const PlanResult& result) {
  const std::string closest =
      result.plan.phases.empty() ? "" : "; what follows is the motion that comes closest";
  switch (result.status) {
    case PlanStatus::kPlanned:
      return "";
    case PlanStatus::kLocallyInfeasible:
      return "no proof that there is no plan: from this guess none was found" + closest;
    case PlanStatus::kCheckFails:
      return "neither a plan nor a proof that there is none: larger planning margins, more "
             "intervals or another guess may make one" +
             closest;
    default:
      return "neither a plan nor a proof that there is none: the search had not ended" + closest;
  }
}

std::string task_words(const PlanOptions& options, const PlanResult& result) {
  std::vector<std::string> objectives;
  for (const ObjectivePart& part : result.objectives) {
    objectives.push_back(fmt::format("{} {} (weight {:g})", part.name,
                                     with_unit(part.value, part.unit), part.weight));
  }
  const auto flights = std::count_if(result.plan.phases.begin(), result.plan.phases.end(),
                                     [](const PlannedPhase& phase) { return phase.flies(); });
  return fmt::format("{}{}, drives held to their {}{}{}", options.task->name,
                     flights > 1 ? fmt::format(", {} in a row", flights) : "",
                     options.limits == DriveLimits::kBox ? "boxes of torque and speed" : "regions",
                     objectives.empty() ? "" : "; ", fmt::join(objectives, ", "));
}

std::string flight_words(const PlanResult& result) {
  const PlannedPhase* flight = longest_flight(result.plan);
  if (flight == nullptr) return "";
  std::string text = fmt::format(
      "{:.4f} s; angular momentum {:.4g} Nm s; turns at {:.4g} rad/s at take-off, {:.4g} at most",
      flight->end_s() - flight->begin_s(), result.angular_momentum_Nm_s, result.take_off_rad_s,
      result.peak_rad_s);
  constexpr double kLeastRate_rad_s = 0.1;  // of less a rise in per cent says nothing
  if (std::abs(result.take_off_rad_s) >= kLeastRate_rad_s) {
    text += fmt::format(" ({:+.1f} %)", 100.0 * (result.peak_rad_s / result.take_off_rad_s - 1.0));
  }
  const auto rise_m = rise_of(result);
  return text + (rise_m ? fmt::format("; {:.3g} m up", *rise_m) : "");
}

std::string margin_words(const LeastMargin& margin) {
  std::string text = fmt::format("{} of margin", with_unit(margin.margin, margin.unit));
  if (std::isfinite(margin.limit)) {
    text += fmt::format(": {} at a limit of {}", with_unit(margin.value, margin.unit),
                        with_unit(margin.limit, margin.unit));
  }
  if (!margin.place.empty()) text += ", " + margin.place;
  return text + fmt::format(", t = {:.4f} s", margin.time_s);
}

std::string price_words(const BoundPrice& part) {
  return with_unit(part.value, part.unit) +
         (part.kept ? ", in samples " + with_unit(*part.kept, part.unit) : "") + "; " +
         more_words(part.objective_per_unit, with_unit(kMore, part.unit));
}

std::string reserve_words(double reserve, const PlanResult& result) {
  return fmt::format("{:g}; {}", reserve,
                     more_words(reserve_price(result.prices), fmt::format("{:g}", kMore)));
}

std::string binding_words(const BindingConstraint& binding) {
  if (!binding.has_times) {
    return fmt::format("{} of {} rows of {}, violated by {:.2g} of their scale at most",
                       binding.instants, binding.of, binding.stance, binding.violation);
  }
  std::string text =
      fmt::format("{} of {} instants of {}, t = {:.4f} to {:.4f} s", binding.instants, binding.of,
                  binding.stance, binding.from_s, binding.until_s);
  if (binding.violation > 0.0) {
    text += fmt::format("; violated by {} at most", with_unit(binding.violation, binding.unit));
  }
  return text;
}

std::string size_words(double value, const std::string& unit) {
  return std::isfinite(value) ? fmt::format("{:.1e}{}", value, unit) : "more than any number";
}

std::string round_words(const PlanRound& round) {
  return fmt::format(
      "{} intervals, {} iterations, {}; objective {:.6g}, constraints off by {}, integration by "
      "{}",
      round.intervals, round.iterations, round.solver, round.objective,
      size_words(round.largest_violation, ""), size_words(round.integration_error_rad, " rad"));
}

std::string change_words(const ChangeTried& change) {
  if (change.is_cut_off && change.to == change.from) {
    return fmt::format("{} {}: not tried, no time was left", change.quantity,
                       with_unit(change.from, change.unit));
  }
  const std::string what = fmt::format("{} {:.4g} -> {}", change.quantity, change.from,
                                       with_unit(change.to, change.unit));
  if (change.is_cut_off) {
    return what + (change.has_plan ? ": a plan is found; no time was left for less"
                                   : ": still none, no time was left for more");
  }
  return what + (change.has_plan ? ": a plan is found" : ": still none, tried no further");
}

}  // namespace torquewright::report
