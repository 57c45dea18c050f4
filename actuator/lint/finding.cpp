// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/finding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace torquewright::actuator::lint {

double limit(const Finding& finding) {
  return std::clamp(finding.stated.value, finding.expected.low, finding.expected.high);
}

std::string with_interval(const RoundedInterval& interval, std::string_view unit) {
  std::string text = fmt::format("{:.4g}", interval.value);
  if (is_one_sided(interval)) {
    text = std::isinf(interval.high) ? fmt::format("at least {:.4g}", interval.low)
                                     : fmt::format("at most {:.4g}", interval.high);
  } else if (std::isinf(interval.high)) {
    return "anything";
  } else if (interval.low != interval.high)
    text += fmt::format(" ({:.4g} to {:.4g})", interval.low, interval.high);
  return unit.empty() ? text : fmt::format("{} {}", text, unit);
}

std::string either(const std::vector<Numerals>& sets) {
  std::string text;
  for (const Numerals& set : sets) {
    text += text.empty() ? "" : " or ";
    for (std::size_t i = 0; i < set.size(); ++i) text += (i == 0 ? "" : " and ") + set[i];
  }
  return text;
}

Severity contradiction(const std::vector<Explanation>& explanations) {
  const bool is_reconciled =
      std::any_of(explanations.begin(), explanations.end(),
                  [](const Explanation& one) { return one.fit != Agreement::kExcludes; });
  return is_reconciled ? Severity::kWarning : Severity::kViolation;
}

}  // namespace torquewright::actuator::lint
