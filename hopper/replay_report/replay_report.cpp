// SPDX-License-Identifier: Apache-2.0
#include "hopper/replay_report/replay_report.hpp"

#include <fmt/format.h>

namespace torquewright::hopper {

std::string_view name_of(DriveLimits limits) { return limits == DriveLimits::kBox ? "box" : "mor"; }

std::string_view name_of(ImpactHandling handling) {
  switch (handling) {
    case ImpactHandling::kNoDerivative:
      return "no_derivative";
    case ImpactHandling::kInvariant:
      return "invariant";
    default:
      return "default";
  }
}

TrialOutcome trial_outcome(const ReplayResult& result) {
  const ReplayOutcome& outcome = result.outcome;
  TrialOutcome kept;
  kept.verdict = outcome.verdict;
  kept.reason = outcome.reason;
  kept.end_time_s = outcome.end_s;
  if (outcome.touch_down) {
    kept.touch_down_time_s = outcome.touch_down->time_s;
    kept.rotation_short_rad = outcome.touch_down->rotation_short_rad;
  }
  for (const TransmissionLoad& load : result.transmission_loads) {
    kept.peak_transmission_Nm.push_back(load.judged().mean);
  }
  return kept;
}

void add_planned_findings(const HopperReport& check, std::vector<Finding>& findings) {
  if (check.check.verdict != actuator::Verdict::kPass) {
    Finding& finding = findings.emplace_back();
    finding.rule = "planned-motion";
    finding.sentence = fmt::format(
        "`hopper check` says {} of the motion as it is planned; a replay says what becomes of it",
        actuator::name_of(check.check.verdict));
  }
  for (const Finding& finding : check.check.findings) {
    if (finding.rule == "assumed") findings.push_back(finding);
  }
}

}  // namespace torquewright::hopper
