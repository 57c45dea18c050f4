// SPDX-License-Identifier: Apache-2.0
#include "src/report/motion/flip_text.hpp"

#include <fmt/format.h>

#include "hopper/motion/ground_line.hpp"
#include "src/report/motion/flip_words.hpp"
#include "src/report/robot/gear_words.hpp"

namespace torquewright::report {
namespace {

using namespace hopper;

constexpr std::size_t kShownBinding = 12;

std::string motion_lines(const FlipAnswer& answer) {
  const PlanResult& result = answer.result;
  std::string text = fmt::format("  robot    {}", answer.robot.name);
  if (!result.plan.phases.empty()) {
    text += fmt::format(", {:.4g} s of motion in {} samples",
                        result.plan.phases.back().end_s() - result.plan.phases.front().begin_s(),
                        result.motion.samples());
  }
  text += "\n  task     " + task_words(answer.options, result) + "\n";
  for (const PlannedPhase& phase : result.plan.phases) {
    text += fmt::format("  phase    {:<7} {:.4f} to {:.4f} s: {:.4f} s, {} intervals\n",
                        phase.stance, phase.begin_s(), phase.end_s(),
                        phase.end_s() - phase.begin_s(), phase.intervals());
  }
  if (!result.motion.ground.is_flat()) {
    text += "  ground   " + hopper::ground_words(result.motion.ground) + "\n";
  }
  const std::string flight = flight_words(result);
  return text + (flight.empty() ? "" : "  flight   " + flight + "\n");
}

std::string load_lines(const PlanResult& result) {
  std::string text;
  if (!result.check) return text;
  for (const TransmissionLoad& load : result.check->transmission_loads) {
    text += fmt::format("  gears    {}: {}\n", load.drive,
                        gear_words(load, fmt::format("{:.4f}", load.judged().time_s)));
  }
  return text;
}

/// What of the check a plan's reader is told: charge taken, and effects of the drives' documents
/// that neither plan nor check reckon with.
std::string finding_lines(const PlanResult& result) {
  std::string text;
  if (!result.check) return text;
  for (const hopper::Finding& finding : result.check->check.findings) {
    if (finding.rule == "battery-charge") text += "  charge   " + finding.sentence + "\n";
    if (finding.rule == "effect-left-out") text += "  left out " + finding.sentence + "\n";
  }
  return text;
}

std::string margin_lines(const std::vector<LeastMargin>& margins) {
  if (margins.empty()) return "";
  std::string text = "\nleast margin of each rule, planning margins not taken off\n";
  for (const LeastMargin& margin : margins) {
    text += fmt::format("  {:<24} {}\n", margin.rule, margin_words(margin));
  }
  return text;
}

std::string binding_lines(const std::vector<BindingConstraint>& binding) {
  if (binding.empty()) return "";
  std::string text = "\nwhat binds\n";
  for (std::size_t i = 0; i < binding.size() && i < kShownBinding; ++i) {
    text += fmt::format("  {:<24} {}\n", binding[i].name, binding_words(binding[i]));
  }
  if (binding.size() > kShownBinding) {
    text += fmt::format("  and {} more (--json lists all)\n", binding.size() - kShownBinding);
  }
  return text;
}

std::string reserve_lines(const FlipAnswer& answer) {
  if (!(answer.options.reserve > 0.0) || answer.result.prices.empty()) return "";
  std::string text =
      fmt::format("\nwhat the reserve of {:g} costs, to first order\n", answer.options.reserve);
  for (const BoundPrice& part : answer.result.prices) {
    text += fmt::format("  {:<24} {}\n", part.name, price_words(part));
  }
  return text + fmt::format("  {:<24} {}\n", "together",
                            reserve_words(answer.options.reserve, answer.result));
}

std::string round_lines(const FlipAnswer& answer) {
  if (answer.result.rounds.empty()) return "";
  std::string text = "\nrounds\n";
  std::size_t number = 0;
  for (const PlanRound& round : answer.result.rounds) {
    text += fmt::format("  {:<3} {}", ++number, round_words(round));
    if (answer.has_seconds) {
      text += fmt::format("; {:.3g} s, {:.3g} s of it in derivatives", round.seconds,
                          round.derivative_seconds);
    }
    text += "\n";
  }
  return text;
}

std::string change_lines(const FlipAnswer& answer) {
  if (answer.result.changes.empty()) return "";
  std::string text = "\none thing changed, the rest as it is\n";
  for (const ChangeTried& change : answer.result.changes) {
    text += "  " + change_words(change) + "\n";
  }
  return text;
}

std::string next_lines(const std::vector<std::string>& next) {
  std::string text = next.empty() ? "" : "\n";
  for (const std::string& line : next) text += "next: " + line + "\n";
  return text;
}

}  // namespace

std::string flip_text(const FlipAnswer& answer) {
  const PlanResult& result = answer.result;
  std::string text = verdict_words(answer.options, result) + "\n";
  const std::string proof = proof_words(result);
  if (!proof.empty()) text += "  " + proof + "\n";
  text += motion_lines(answer);
  text += load_lines(result) + finding_lines(result);
  text += margin_lines(result.least_margins);
  text += reserve_lines(answer) + answer.chosen_reserve;
  text += binding_lines(result.binding);
  text += round_lines(answer);
  text += change_lines(answer);
  return text + next_lines(answer.next);
}

}  // namespace torquewright::report
