// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/several_sources.hpp"

#include <fmt/format.h>

namespace torquewright::actuator::lint {
namespace {

/// "35 (+4.5 %)"
std::string beside(double other, double taken) {
  return fmt::format("{:g} ({:+.3g} %)", other, 100.0 * (other / taken - 1.0));
}

Finding finding_of(const Actuator& document, const Statement& statement) {
  Finding finding;
  finding.severity = Severity::kNote;
  finding.rule = "several-sources";
  finding.actuator = document.name;
  std::string others;
  for (const double other : statement.also) {
    others += (others.empty() ? "" : ", ") + beside(other, statement.printed);
  }
  finding.sentence = fmt::format("{} is taken as {:g}; of its sources others say {}",
                                 statement.pointer, statement.printed, others);
  finding.stated = exact(statement.printed, statement.pointer);
  finding.expected = exact(statement.also.front());
  return finding;
}

}  // namespace

std::vector<Finding> several_sources(const Actuator& document) {
  std::vector<Finding> findings;
  for (const Statement& statement : document.statements) {
    if (!statement.also.empty()) findings.push_back(finding_of(document, statement));
  }
  return findings;
}

}  // namespace torquewright::actuator::lint
