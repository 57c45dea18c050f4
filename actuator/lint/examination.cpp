// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/examination.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "actuator/lint/few_digits.hpp"
#include "actuator/lint/idle_limit.hpp"
#include "actuator/lint/joint_explanation.hpp"
#include "actuator/lint/several_sources.hpp"

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

/// Possible, but worth a look.
Finding plausibility_of(const Check& check, const Actuator& document, const RoundedInterval& stated,
                        const RoundedInterval& expected) {
  Finding finding = finding_of(check, document, stated, expected);
  finding.severity = Severity::kNote;
  finding.sentence = sentence_of(check, stated, expected) + ": possible, but check it.";
  return finding;
}

/// The whole sheet's explanation decides: a pair's own may break others.
void explain_jointly(const Actuator& document, const std::vector<Comparison>& comparisons,
                     Finding& finding) {
  JointExplanation joint = explain(document, comparisons);
  finding.severity = joint.readings.empty() ? Severity::kViolation : Severity::kWarning;
  finding.explained_by = std::move(joint.readings);
  finding.culprits = std::move(joint.culprits);
}

/// The only contradiction of a document.
Finding contradiction_of(const Check& check, const Actuator& document, const Pair& pair,
                         const std::vector<Comparison>& comparisons) {
  Finding finding = finding_of(check, document, pair.stated, pair.expected);
  explain_jointly(document, comparisons, finding);
  finding.sentence = sentence_of(check, pair.stated, pair.expected);
  finding.sentence += finding.severity == Severity::kWarning
                          ? ": settle which of the readings below is meant, and state it."
                          : fmt::format(": no known reading reconciles them; correct {}.",
                                        either(finding.culprits));
  return finding;
}

/// Several contradictions of a document are one finding: what explains them all, or spoils them.
Finding contradictions_of(const std::vector<const Check*>& checks, const Actuator& document,
                          const std::vector<Comparison>& comparisons) {
  const Interpretation own = as_stated(document);
  const Pair first = pair_of(*checks.front(), own).value();
  Finding finding = finding_of(*checks.front(), document, first.stated, first.expected);
  finding.explanations.clear();
  finding.rule = "whole-sheet";
  explain_jointly(document, comparisons, finding);
  std::vector<std::string> pointers;
  finding.sentence = fmt::format("{} numbers contradict the others: ", checks.size());
  for (const Check* check : checks) {
    const Pair pair = pair_of(*check, own).value();
    pointers = united(united(pointers, pair.stated.pointers), pair.expected.pointers);
    finding.sentence += sentence_of(*check, pair.stated, pair.expected) + "; ";
  }
  finding.assumed = assumed_among(document, pointers);
  finding.sentence += finding.severity == Severity::kWarning
                          ? "settle whether the reading below is meant, and state it."
                          : "no two readings reconcile them.";
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
  const auto fits = [](const Explanation& one) {
    return one.fit == Agreement::kFits && one.breaks.empty();
  };
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

/// Of a check that stands alone.
Finding doubt_of(const Check& check, const Actuator& document, const Pair& pair) {
  Finding finding = finding_of(check, document, pair.stated, pair.expected);
  finding.severity = contradiction(finding.explanations);
  finding.sentence = fmt::format("{}: settle whether the reading below is meant, and state it.",
                                 sentence_of(check, pair.stated, pair.expected));
  return finding;
}

/// What one check has to say, but for contradictions, which are explained together.
std::optional<Finding> note_of(const Check& check, const Actuator& document, const Pair& pair) {
  if (is_met(check.demand, pair.stated, pair.expected)) {
    return rivals_of(check, document, pair.stated, pair.expected);
  }
  if (is_tolerated(check, document, pair)) {
    return tolerated(check, document, pair.stated, pair.expected);
  }
  if (check.stands_alone) return doubt_of(check, document, pair);
  return plausibility_of(check, document, pair.stated, pair.expected);
}

void compare(const Check& check, const Actuator& document, Examination& examination) {
  const std::optional<Pair> pair = pair_of(check, as_stated(document));
  if (!pair) return;
  examination.comparisons.push_back(
      {std::string(check.rule), std::string(check.unit), std::string(check.equation), check.demand,
       pair->stated, pair->expected, is_met(check.demand, pair->stated, pair->expected),
       is_tolerated(check, document, *pair), check.weight});
}

}  // namespace

Examination examine(const Actuator& document) {
  Examination examination;
  examination.actuator = document.name;
  examination.findings = several_sources(document);
  if (document.envelope) return examination;  // no number of a curve follows from another
  for (const Check* check : library()) compare(*check, document, examination);
  const Interpretation own = as_stated(document);
  const std::vector<const Check*> contradicting = contradicted(own);
  if (contradicting.size() > 1) {
    examination.findings.push_back(
        contradictions_of(contradicting, document, examination.comparisons));
  }
  for (const Check* check : library()) {
    const std::optional<Pair> pair = pair_of(*check, own);
    if (!pair) continue;
    if (std::find(contradicting.begin(), contradicting.end(), check) == contradicting.end()) {
      if (auto note = note_of(*check, document, *pair)) examination.findings.push_back(*note);
    } else if (contradicting.size() == 1) {
      examination.findings.push_back(
          contradiction_of(*check, document, *pair, examination.comparisons));
    }
  }
  for (Finding& note : few_digits(document)) examination.findings.push_back(std::move(note));
  if (auto note = idle_regeneration_limit(document)) examination.findings.push_back(*note);
  return examination;
}

Report examine_all(std::span<const Actuator> documents) {
  Report report;
  for (const Actuator& document : documents) {
    report.examinations.push_back(examine(document));
    const std::vector<Finding>& found = report.examinations.back().findings;
    report.findings.insert(report.findings.end(), found.begin(), found.end());
  }
  std::vector<Actuator> wound;
  std::copy_if(documents.begin(), documents.end(), std::back_inserter(wound),
               [](const Actuator& document) { return !document.envelope; });
  report.common_factor = common_factor(wound);
  if (report.common_factor) {
    if (auto finding = finding_of(*report.common_factor)) report.findings.push_back(*finding);
  }
  for (Finding& finding : same_motor(wound)) report.findings.push_back(std::move(finding));
  return report;
}

bool has_contradiction(const Report& report) {
  return std::any_of(report.findings.begin(), report.findings.end(),
                     [](const Finding& finding) { return finding.severity != Severity::kNote; });
}

}  // namespace torquewright::actuator::lint
