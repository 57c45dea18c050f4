// SPDX-License-Identifier: Apache-2.0
#include "hopper/skill/policy_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace torquewright::hopper {
namespace {

Finding finding_of(const char* rule, actuator::Severity severity, std::string sentence) {
  Finding finding;
  finding.rule = rule;
  finding.severity = severity;
  finding.sentence = std::move(sentence);
  return finding;
}

}  // namespace

std::vector<Finding> policy_findings(const PolicyDocument& document, const PolicyUse& use) {
  std::vector<Finding> findings;
  if (use.in_plane) {
    findings.push_back(finding_of("policy-plane", actuator::Severity::kNote,
                                  "the robot moves in the plane of x and z alone, as the task "
                                  "says"));
  }
  if (!document.limits.empty() && document.limits != use.limits) {
    findings.push_back(
        finding_of("policy-limits", actuator::Severity::kWarning,
                   fmt::format("the policy was trained with limits \"{}\", this run has \"{}\"",
                               document.limits, use.limits)));
  }
  for (const TrainedWith& with : document.trained_with) {
    if (std::find(use.sha256.begin(), use.sha256.end(), with.sha256) != use.sha256.end()) continue;
    findings.push_back(finding_of(
        "policy-drives", actuator::Severity::kWarning,
        fmt::format("the policy was trained with another {}: no document of this robot has its "
                    "bytes (SHA-256 {:.12})",
                    std::filesystem::path(with.path).filename().string(), with.sha256)));
  }
  return findings;
}

}  // namespace torquewright::hopper
