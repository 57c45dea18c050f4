// SPDX-License-Identifier: Apache-2.0
#include "src/report/actuator/lint_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace torquewright::report {
namespace {

using namespace actuator::lint;

constexpr const char* kRounding =
    "An interval is what rounding leaves open: half a unit of the last decimal (10 is 9.5 to "
    "10.5).\n"
    "Zeros at the end of decimals are lost on reading, so that 20.0 counts as 20. Whole gear "
    "ratios,\n"
    "efficiencies of 1, and voltages and currents at which something is stated count as exact.\n";

std::string_view mark(actuator::lint::Agreement fit) {
  switch (fit) {
    case actuator::lint::Agreement::kFits:
      return "fits";
    case actuator::lint::Agreement::kAdmits:
      return "if loaded or capped";
    case actuator::lint::Agreement::kExcludes:
      break;
  }
  return "no";
}

std::string_view sign(actuator::lint::Demand demand) {
  switch (demand) {
    case actuator::lint::Demand::kAtMost:
      return "<=";
    case actuator::lint::Demand::kAtLeast:
      return ">=";
    case actuator::lint::Demand::kEqual:
      break;
  }
  return "=";
}

std::string comparison_row(const Comparison& row) {
  return fmt::format("  {:<26}{:>34} {:<2} {:<42} {}\n", row.rule,
                     with_interval(row.stated, row.unit), sign(row.demand),
                     with_interval(row.expected, row.unit),
                     row.agrees         ? "agrees"
                     : row.is_tolerated ? "tolerated"
                                        : "DISAGREES");
}

std::string examination_text(const Examination& examination) {
  std::string text = examination.actuator + "\n";
  if (examination.comparisons.empty()) {
    return text +
           "  nothing is stated twice: a \"datasheet\" block would give the lint its numbers\n";
  }
  text += fmt::format("  {:<26}{:>34}    {}\n", "rule", "stated", "follows from others");
  for (const Comparison& row : examination.comparisons) text += comparison_row(row);
  return text;
}

std::string explanation_row(const Explanation& explanation, const std::string& unit) {
  const std::string value =
      explanation.expected ? with_interval(*explanation.expected, unit) : std::string();
  const std::string but =
      explanation.breaks.empty() ? "" : fmt::format(", but breaks {}", explanation.breaks);
  return fmt::format("    {:<62} {:<32} {}{}\n", explanation.sentence, value, mark(explanation.fit),
                     but);
}

std::string finding_text(const actuator::lint::Finding& finding) {
  std::string text = fmt::format("\n{}: {}: {}: {}\n", name_of(finding.severity), finding.actuator,
                                 finding.rule, finding.sentence);
  if (!finding.expected.pointers.empty()) {
    text += fmt::format("  follows from {}\n", fmt::join(finding.expected.pointers, ", "));
  }
  if (!finding.assumed.empty()) {
    text += fmt::format("  assumed, neither published nor measured: {}\n",
                        fmt::join(finding.assumed, ", "));
  }
  if (!finding.explanations.empty()) text += "  would it agree with:\n";
  for (const Explanation& one : finding.explanations) text += explanation_row(one, finding.unit);
  if (!finding.explained_by.empty()) {
    text +=
        fmt::format("  the whole sheet agrees with: {}\n", fmt::join(finding.explained_by, "; "));
  }
  if (!finding.culprits.empty()) {
    text += fmt::format("  or else it is spoilt by: {}\n", either(finding.culprits));
  }
  return text;
}

std::string common_text(const CommonFactor& common) {
  std::string text =
      fmt::format("\nno-load speed c V / (Kt N) by convention, rad/s\n  {:<29}{:>6}", "", "c");
  for (const RequiredFactor& one : common.required) text += fmt::format("{:>16}", one.actuator);
  text += "\n";
  for (const FactorCandidate& row : common.candidates) {
    text += fmt::format("  {:<29}{:>6.3f}", row.sentence, row.factor);
    for (const RoundedInterval& speed_rad_s : row.speeds_rad_s)
      text += fmt::format("{:>16.2f}", speed_rad_s.value);
    text += fmt::format("  {}\n", mark(row.fit));
  }
  text += fmt::format("  {:<29}{:>6}", "stated", "");
  for (const RequiredFactor& one : common.required)
    text += fmt::format("{:>16g}", one.speed_rad_s.value);
  text += fmt::format("\n  {:<29}{:>6}", "c that the stated needs", "");
  for (const RequiredFactor& one : common.required) {
    text += fmt::format("{:>16}", fmt::format("{:.3f}...{:.3f}", one.factor.low, one.factor.high));
  }
  return text + "\n";
}

}  // namespace

std::string lint_answer(const Report& report) {
  const auto contradictions = std::count_if(
      report.findings.begin(), report.findings.end(),
      [](const actuator::lint::Finding& one) { return one.severity != actuator::Severity::kNote; });
  if (contradictions == 0) return "pass: no contradiction";
  return fmt::format("fail: {} contradiction{}", contradictions, contradictions == 1 ? "" : "s");
}

std::string lint_text(const Report& report, actuator::Severity least) {
  std::string text;
  for (const Examination& examination : report.examinations) text += examination_text(examination);
  if (report.common_factor) text += common_text(*report.common_factor);
  for (const actuator::lint::Finding& finding : report.findings) {
    if (finding.severity >= least) text += finding_text(finding);
  }
  if (report.findings.empty()) text += "\nno contradiction\n";
  return text + "\n" + kRounding;
}

}  // namespace torquewright::report
