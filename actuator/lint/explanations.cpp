// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "actuator/lint/check.hpp"
#include "actuator/lint/joint_explanation.hpp"

namespace torquewright::actuator::lint {
namespace {

/// A loaded or capped speed is at least this part of the no-load speed; less is another matter.
constexpr double kLeastLoadedShare = 0.5;

Agreement fit_of(const Check& check, const RoundedInterval& stated,
                 const RoundedInterval& expected) {
  if (is_met(check.demand, stated, expected)) return Agreement::kFits;
  const bool may_be_loaded = check.below_is_load && lies_above(expected, stated) &&
                             stated.high >= kLeastLoadedShare * expected.low;
  return may_be_loaded ? Agreement::kAdmits : Agreement::kExcludes;
}

/// To round-off.
bool is_same(const RoundedInterval& one, const RoundedInterval& other) {
  constexpr double kRoundOff = 1e-12;
  const auto is_near = [](double a, double b) {
    return a == b || std::abs(a - b) <= kRoundOff * std::abs(a);
  };
  return is_near(one.low, other.low) && is_near(one.high, other.high);
}

/// A rule that the reading breaks though it holds as stated; empty: none.
std::string_view broken_by(const Interpretation& reading, const Interpretation& own) {
  const std::vector<const Check*> before = contradicted(own);
  for (const Check* check : contradicted(reading)) {
    if (std::find(before.begin(), before.end(), check) == before.end()) return check->rule;
  }
  return "";
}

/// The interpretation that is the document's own may still be a load: a speed that is not the
/// no-load one.
void add_load(const Check& check, const RoundedInterval& stated, const RoundedInterval& expected,
              std::vector<Explanation>& list) {
  if (fit_of(check, stated, expected) != Agreement::kAdmits) return;
  list.push_back({"a loaded or capped speed, not the no-load speed", expected, Agreement::kAdmits});
}

std::vector<Explanation> joined(std::vector<Explanation> list, std::vector<Explanation> more) {
  for (Explanation& one : more) list.push_back(std::move(one));
  return list;
}

/// Whole numbers that end in zeros may be targets of fewer figures: 20 as 15 to 25.
void add_round_number(const Check& check, const RoundedInterval& stated,
                      const RoundedInterval& expected, std::vector<Explanation>& list) {
  if (is_one_sided(stated)) return;
  if (stated.low == stated.high || std::fmod(stated.value, 10.0) != 0.0) return;
  double unit = 10.0;
  while (std::fmod(stated.value, 10.0 * unit) == 0.0) unit *= 10.0;
  const RoundedInterval target{
      stated.value, stated.value - 0.5 * unit, stated.value + 0.5 * unit, {}};
  if (!is_met(check.demand, target, expected)) return;
  list.push_back({fmt::format("a round number: {:g} printed for {:g} to {:g}", stated.value,
                              target.low, target.high),
                  std::nullopt, Agreement::kFits});
}

}  // namespace

bool is_met(Demand demand, const RoundedInterval& stated, const RoundedInterval& expected) {
  const bool is_too_high = lies_above(stated, expected);
  const bool is_too_low = lies_above(expected, stated);
  return !(is_too_high && demand != Demand::kAtLeast) && !(is_too_low && demand != Demand::kAtMost);
}

std::vector<Explanation> own_explanations(const Check& check, const Actuator& document,
                                          const RoundedInterval& stated,
                                          const RoundedInterval& expected) {
  std::vector<Explanation> list;
  add_load(check, stated, expected, list);
  if (check.further) list = joined(std::move(list), check.further(document, stated, expected));
  add_round_number(check, stated, expected, list);
  return list;
}

std::vector<Explanation> explanations(const Check& check, const Actuator& document) {
  const Interpretation own = as_stated(document);
  const std::optional<RoundedInterval> stated = check.stated(document);
  const std::optional<RoundedInterval> expected = check.expected(own);
  if (!stated || !expected) return {};
  std::vector<Explanation> list;
  add_load(check, *stated, *expected, list);
  for (const Interpreter interpret : check.interpreters) {
    for (const Interpretation& interpretation : interpret(own)) {
      const std::optional<RoundedInterval> then = check.expected(interpretation);
      if (!then || is_same(*then, *expected)) continue;
      list.push_back({interpretation.sentence, then, fit_of(check, *stated, *then)});
      if (list.back().fit != Agreement::kExcludes)
        list.back().breaks = broken_by(interpretation, own);
    }
  }
  if (check.further) list = joined(std::move(list), check.further(document, *stated, *expected));
  add_round_number(check, *stated, *expected, list);
  return list;
}

}  // namespace torquewright::actuator::lint
