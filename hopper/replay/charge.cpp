// SPDX-License-Identifier: Apache-2.0
#include "hopper/replay/charge.hpp"

#include "hopper/demand/battery_charge.hpp"

namespace torquewright::hopper {

void judge_charge(const Robot& robot, const actuator::OperatingConditions& conditions,
                  const Record& record, ReplayResult& result) {
  ReplayOutcome& outcome = result.outcome;
  for (Finding& finding : battery_charge_findings(robot, conditions, record.drawn_Ah)) {
    const bool is_up =
        outcome.verdict == ReplayVerdict::kStands || outcome.verdict == ReplayVerdict::kTrembles;
    if (finding.severity == actuator::Severity::kViolation && is_up) {
      outcome.verdict = ReplayVerdict::kMissed;
      outcome.reason = "its battery does not hold what it took: " + finding.sentence;
    }
    result.findings.push_back(std::move(finding));
  }
}

}  // namespace torquewright::hopper
