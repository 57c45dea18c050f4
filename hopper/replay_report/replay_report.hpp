// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hopper/replay/replay.hpp"
#include "hopper/trials/explanation.hpp"

namespace torquewright::hopper {

/// Names as options and documents have them.
std::string_view name_of(DriveLimits limits);
std::string_view name_of(ImpactHandling handling);

/// Results of randomised trials.
struct ReplayTrials {
  std::uint64_t seed = 0;
  double required_share = 1.0;                        ///< Share of the trials that must stand.
  std::size_t first = 0;                              ///< Number of the first of the outcomes.
  std::vector<std::optional<TrialOutcome>> outcomes;  ///< Outcomes; none: the trial was not begun.

  std::vector<CauseEffect> causes;  ///< Each thing that varies, alone; empty: not asked for.

  TrialCounts counts() const { return counted(outcomes); }
};

/// Returns what is kept of a trial's run.
TrialOutcome trial_outcome(const ReplayResult& result);

/// The whole answer of a replay.
struct ReplayReport {
  ReplayOptions options;
  ReplayResult result;           ///< Result of the run as documented.
  std::vector<SweptStep> sweep;  ///< Runs with other steps; empty where none were asked for.
  std::optional<ReplayTrials> trials;
};

/// Adds what of the motion's own check a replay's reader must know.
void add_planned_findings(const HopperReport& check, std::vector<Finding>& findings);

}  // namespace torquewright::hopper
