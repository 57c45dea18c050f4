// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/examination.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace torquewright::actuator::lint {
namespace {

std::vector<std::string> assumed_among(const Actuator& document,
                                       const std::vector<std::string>& pointers) {
  std::vector<std::string> assumed;
  for (const std::string& pointer : document.assumed) {
    const bool is_used =
        std::any_of(pointers.begin(), pointers.end(), [&](const std::string& used) {
          return used == pointer || used.starts_with(pointer + "/") ||
                 pointer.starts_with(used + "/");
        });
    if (is_used) assumed.push_back(pointer);
  }
  return assumed;
}

/// How far apart the nearest ends of both intervals are, in percent of what is expected.
std::string distance(const RoundedInterval& stated, const RoundedInterval& expected) {
  if (expected.low <= 0.0) return "";
  const bool is_above = lies_above(stated, expected);
  const double nearest = is_above ? stated.low / expected.high : stated.high / expected.low;
  return fmt::format(", {} by {:.1f} %, rounding allowed for", is_above ? "too much" : "too little",
                     100.0 * std::abs(nearest - 1.0));
}

std::string_view wording(Demand demand) {
  switch (demand) {
    case Demand::kAtMost:
      return "must be at most";
    case Demand::kAtLeast:
      return "must be at least";
    case Demand::kEqual:
      break;
  }
  return "follows as";
}

std::string sentence_of(const Check& check, const RoundedInterval& stated,
                        const RoundedInterval& expected) {
  return fmt::format("{} says {}; by {} it {} {}{}", stated.pointers.front(),
                     with_interval(stated, check.unit), check.equation, wording(check.demand),
                     with_interval(expected, check.unit), distance(stated, expected));
}

Finding finding_of(const Check& check, const Actuator& document, const RoundedInterval& stated,
                   const RoundedInterval& expected) {
  Finding finding;
  finding.rule = check.rule;
  finding.actuator = document.name;
  finding.unit = check.unit;
  finding.stated = stated;
  finding.expected = expected;
  finding.assumed = assumed_among(document, united(stated.pointers, expected.pointers));
  finding.explanations = explanations(check, document);
  return finding;
}

/// Whether both are apart by no more than catalogues are, though by more than their rounding.
bool is_tolerated(const Check& check, const Actuator& document, const RoundedInterval& stated,
                  const RoundedInterval& expected) {
  if (check.tolerance == nullptr) return is_met(check.demand, stated, expected);
  const Tolerance tolerance = check.tolerance({document, stated, expected});
  RoundedInterval admitted = expected;
  admitted.low *= tolerance.least;
  admitted.high *= tolerance.greatest;
  return is_met(check.demand, stated, admitted);
}

/// What a sheet may well state, with the number.
Finding tolerated(const Check& check, const Actuator& document, const RoundedInterval& stated,
                  const RoundedInterval& expected) {
  const Tolerance tolerance = check.tolerance({document, stated, expected});
  Finding finding = finding_of(check, document, stated, expected);
  finding.severity = Severity::kNote;
  // Other readings are of interest where the one that is taken was assumed.
  if (finding.assumed.empty()) finding.explanations.clear();
  finding.sentence = fmt::format("{}: within what catalogues leave open, {:.0f} to {:.0f} % of it.",
                                 sentence_of(check, stated, expected), 100.0 * tolerance.least,
                                 100.0 * tolerance.greatest);
  return finding;
}

Finding contradiction_of(const Check& check, const Actuator& document,
                         const RoundedInterval& stated, const RoundedInterval& expected) {
  Finding finding = finding_of(check, document, stated, expected);
  finding.sentence = sentence_of(check, stated, expected);
  if (check.weight == Weight::kPlausibility) {
    finding.severity = Severity::kNote;
    finding.sentence += ": possible, but check it.";
    return finding;
  }
  finding.severity = contradiction(finding.explanations);
  finding.sentence += finding.severity == Severity::kWarning
                          ? ": settle which of the readings below is meant, and state it."
                          : fmt::format(": no known reading reconciles them; correct {} or {}.",
                                        stated.pointers.front(), expected.pointers.front());
  return finding;
}

/// An assumed convention with which the numbers agree, where another would do as well.
std::optional<Finding> rivals_of(const Check& check, const Actuator& document,
                                 const RoundedInterval& stated, const RoundedInterval& expected) {
  constexpr std::string_view kConvention = "/motor/torque_constant_convention";
  const bool is_assumed = std::find(document.assumed.begin(), document.assumed.end(),
                                    kConvention) != document.assumed.end();
  if (!is_assumed || check.interpreters.empty() ||
      check.interpreters.front() != speed_interpretations) {
    return std::nullopt;
  }
  Finding finding = finding_of(check, document, stated, expected);
  std::erase_if(finding.explanations, [](const Explanation& one) { return !one.expected; });
  const auto fits = [](const Explanation& one) { return one.fit == Agreement::kFits; };
  if (std::none_of(finding.explanations.begin(), finding.explanations.end(), fits)) {
    return std::nullopt;
  }
  finding.severity = Severity::kNote;
  finding.sentence = fmt::format(
      "{} says {} and agrees with {}, but {} is assumed, and another convention fits as well: "
      "ask the maker.",
      stated.pointers.front(), with_interval(stated, check.unit),
      with_interval(expected, check.unit), kConvention);
  return finding;
}

void apply(const Check& check, const Actuator& document, Examination& examination) {
  const std::optional<RoundedInterval> stated = check.stated(document);
  if (!stated) return;
  const std::optional<RoundedInterval> expected = check.expected(as_stated(document));
  if (!expected) return;
  const bool agrees = is_met(check.demand, *stated, *expected);
  examination.comparisons.push_back({std::string(check.rule), std::string(check.unit),
                                     std::string(check.equation), check.demand, *stated, *expected,
                                     agrees, is_tolerated(check, document, *stated, *expected)});
  if (!agrees && is_tolerated(check, document, *stated, *expected)) {
    examination.findings.push_back(tolerated(check, document, *stated, *expected));
  } else if (!agrees) {
    examination.findings.push_back(contradiction_of(check, document, *stated, *expected));
  } else if (const auto note = rivals_of(check, document, *stated, *expected)) {
    examination.findings.push_back(*note);
  }
}

}  // namespace

Examination examine(const Actuator& document) {
  Examination examination;
  examination.actuator = document.name;
  for (const Check* check : library()) apply(*check, document, examination);
  return examination;
}

Report examine_all(std::span<const Actuator> documents) {
  Report report;
  for (const Actuator& document : documents) {
    report.examinations.push_back(examine(document));
    const std::vector<Finding>& found = report.examinations.back().findings;
    report.findings.insert(report.findings.end(), found.begin(), found.end());
  }
  report.common_factor = common_factor(documents);
  if (report.common_factor) {
    if (auto finding = finding_of(*report.common_factor)) report.findings.push_back(*finding);
  }
  for (Finding& finding : same_motor(documents)) report.findings.push_back(std::move(finding));
  return report;
}

bool has_contradiction(const Report& report) {
  return std::any_of(report.findings.begin(), report.findings.end(),
                     [](const Finding& finding) { return finding.severity != Severity::kNote; });
}

}  // namespace torquewright::actuator::lint
