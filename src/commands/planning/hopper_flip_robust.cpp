// SPDX-License-Identifier: Apache-2.0
#include "src/commands/planning/hopper_flip_robust.hpp"

#include <fmt/format.h>

#include <utility>

#include "src/commands/planning/hopper_flip_trials.hpp"
#include "src/interrupt.hpp"
#include "src/report/parts/progress_line.hpp"

namespace torquewright::cli {
namespace {

/// Plans and tries, saying on stderr which reserve it is at.
class RobustPlanner {
 public:
  RobustPlanner(const HopperFlipRequest& request, const HopperFlipInputs& inputs, PlanTrials trials)
      : request_(request), inputs_(inputs), trials_(std::move(trials)) {}

  hopper::PlanResult plan(double reserve) {
    hopper::PlanOptions options = inputs_.plan;
    options.reserve = reserve;
    set_margins(request_, options);
    options.should_stop = is_interrupted;
    options.on_progress = [&](const hopper::PlanProgress& at) {
      progress_.show(fmt::format("reserve {:g}: round {}, iteration {}, objective {:.5g}", reserve,
                                 at.round + 1, at.iteration, at.objective));
    };
    return hopper::plan_motion(inputs_.robot.robot, options);
  }

  hopper::TrialCounts fare(const hopper::PlanResult& plan, std::uint64_t seed) {
    progress_.show(fmt::format("{} trials, seed {}", trials_.replay.trials, seed));
    PlanTrials trials = trials_;
    trials.replay.seed = seed;
    return hopper::counted(
        outcomes_of(trials, inputs_.plan.check, inputs_.robot.robot, plan, TrialThreads::kAll));
  }

 private:
  const HopperFlipRequest& request_;
  const HopperFlipInputs& inputs_;
  PlanTrials trials_;
  report::ProgressLine progress_;
};

std::string share_words(const hopper::TrialCounts& counts) {
  return fmt::format("{} of {}", counts.succeeded, counts.done());
}

}  // namespace

RobustChoice plan_robustly(const HopperFlipRequest& request, HopperFlipInputs& inputs,
                           hopper::PlanResult& result) {
  PlanTrials trials = *read_plan_trials(request, inputs);
  inputs.columns.push_back(trials.read.document);
  RobustPlanner planner(request, inputs, std::move(trials));
  RobustChoice robust;
  robust.fresh_seed = request.trials.seed + 1;
  robust.choice = hopper::search_reserve(
      inputs.plan.reserve,
      {[&](double reserve) { return planner.plan(reserve); },
       [&](const hopper::PlanResult& plan) { return planner.fare(plan, request.trials.seed); },
       is_interrupted});
  const auto& tried = robust.choice.tried;
  const hopper::TriedReserve& kept = tried[robust.choice.chosen.value_or(0)];
  result = kept.result;
  inputs.plan.reserve = kept.reserve;
  set_margins(request, inputs.plan);
  if (!robust.choice.chosen) return robust;
  robust.fresh = planner.fare(kept.result, robust.fresh_seed);
  if (tried.front().trials)
    robust.fresh_least = planner.fare(tried.front().result, robust.fresh_seed);
  return robust;
}

std::string robust_lines(const HopperFlipRequest& request, const RobustChoice& robust) {
  std::string text =
      fmt::format("\nreserve, chosen by trials of {} ({}, seed {})\n", request.robust_file,
                  request.trials.controller, request.trials.seed);
  const auto& tried = robust.choice.tried;
  for (std::size_t i = 0; i < tried.size(); ++i) {
    const bool is_chosen = robust.choice.chosen == i;
    text += fmt::format("  {} {:<6g} ", is_chosen ? '>' : ' ', tried[i].reserve);
    text += tried[i].trials ? fmt::format("objective {:<9.5g} {} do it\n",
                                          tried[i].result.objective, share_words(*tried[i].trials))
                            : fmt::format("no plan: {}\n", name_of(tried[i].result.status));
  }
  if (is_interrupted()) text += "  ended by Ctrl-C: what else there is was not tried\n";
  if (!robust.choice.chosen || robust.fresh.done() == 0) return text;
  text += fmt::format("  of other draws (seed {}): {} do it", robust.fresh_seed,
                      share_words(robust.fresh));
  if (robust.fresh_least.done() > 0 && *robust.choice.chosen > 0) {
    text += fmt::format(", {} with a reserve of {:g}", share_words(robust.fresh_least),
                        tried.front().reserve);
  }
  return text + "\n";
}

}  // namespace torquewright::cli
