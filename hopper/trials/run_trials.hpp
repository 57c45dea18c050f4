// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hopper/trials/success_rate.hpp"
#include "hopper/verdict/verdict.hpp"

namespace torquewright::hopper {

/// Kept results of a trial.
struct TrialOutcome {
  ReplayVerdict verdict = ReplayVerdict::kUnfinished;
  std::string reason;  ///< Reason for what is not success.
  double end_time_s = 0.0;
  std::optional<double> touch_down_time_s;
  std::optional<double> rotation_short_rad;
  std::vector<double> peak_transmission_Nm;  ///< Peak loads of transmissions, by drive.
};

struct TrialRun {
  std::size_t count = 0;
  std::size_t threads = 0;  ///< 0: as many as the processor runs at once.
  /// Asked before each trial, in any thread; empty: never. Trials that run are ended by whoever
  /// runs them.
  std::function<bool()> should_stop;
  /// Told after each trial how many are done, by one thread at a time; may be empty.
  std::function<void(std::size_t)> progress;
};

/// Runs trials 0 ... count - 1, begun in that order, and returns their outcomes in that order: the
/// same for any number of threads where `trial` depends on its number alone. None for those that
/// were not begun. `trial` is called from several threads at once. What it throws ends the rest and
/// is thrown on: of several, that of the lowest number, which is the same for any number of
/// threads.
std::vector<std::optional<TrialOutcome>> run_trials(
    const TrialRun& run, const std::function<TrialOutcome(std::size_t)>& trial);

TrialCounts counted(const std::vector<std::optional<TrialOutcome>>& outcomes);

}  // namespace torquewright::hopper
