// SPDX-License-Identifier: Apache-2.0
#include "hopper/trials/run_trials.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>

#include "simulation/in_parallel.hpp"

namespace torquewright::hopper {
namespace {

std::size_t threads_of(const TrialRun& run) {
  if (run.threads > 0) return run.threads;
  return simulation::threads_of_machine();
}

}  // namespace

std::vector<std::optional<TrialOutcome>> run_trials(
    const TrialRun& run, const std::function<TrialOutcome(std::size_t)>& trial) {
  std::vector<std::optional<TrialOutcome>> outcomes(run.count);
  std::atomic<bool> is_stopped = false;
  std::mutex telling;
  std::size_t done = 0;
  simulation::in_parallel(run.count, threads_of(run), [&](std::size_t number, std::size_t) {
    if (!is_stopped && run.should_stop && run.should_stop()) is_stopped = true;
    if (is_stopped) return;
    outcomes[number] = trial(number);
    if (!run.progress) return;
    const std::lock_guard lock(telling);
    run.progress(++done);
  });
  return outcomes;
}

TrialCounts counted(const std::vector<std::optional<TrialOutcome>>& outcomes) {
  TrialCounts counts;
  for (const std::optional<TrialOutcome>& outcome : outcomes) {
    switch (outcome ? outcome->verdict : ReplayVerdict::kUnfinished) {
      case ReplayVerdict::kStands:
        ++counts.succeeded;
        break;
      case ReplayVerdict::kMissed:
      case ReplayVerdict::kTrembles:
      case ReplayVerdict::kFell:
        ++counts.failed;
        break;
      case ReplayVerdict::kUnfinished:
      case ReplayVerdict::kUndecided:
        ++counts.unfinished;
        break;
    }
  }
  return counts;
}

}  // namespace torquewright::hopper
