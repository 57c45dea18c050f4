// SPDX-License-Identifier: Apache-2.0
#include "gearbox/constraints/condition.hpp"

#include <fmt/format.h>

namespace torquewright::gearbox {

namespace {

std::string_view wording(Sense sense) {
  switch (sense) {
    case Sense::kAtLeast:
      return "at least";
    case Sense::kMoreThan:
      return "more than";
    case Sense::kAtMost:
      return "at most";
  }
  return "";
}

std::string suffix(const std::string& unit) { return unit == "1" ? "" : " " + unit; }

std::string sentence_of(const Condition& condition, const Rational& margin, bool satisfied) {
  const std::string difference =
      fmt::format("{:.3g}{}", Rational(abs(margin)).get_d(), suffix(condition.unit));
  const std::string head = fmt::format(
      "{}: {} {}; {} {} {} asked for: ", condition.name, with_unit(condition.value, condition.unit),
      condition.meaning, wording(condition.sense), with_unit(condition.limit, condition.unit),
      condition.unit == "1" ? "is" : "are");
  if (satisfied) return head + difference + " to spare.";
  const std::string tail = condition.sense == Sense::kAtMost ? " too much" : " missing";
  return head + difference + tail +
         (condition.remedy.empty() ? "." : "; " + condition.remedy + ".");
}

}  // namespace

std::string with_unit(const Rational& value, const std::string& unit) {
  if (value.get_den() == 1) return value.get_num().get_str() + suffix(unit);
  return fmt::format("{:.4g}{}", value.get_d(), suffix(unit));
}

Rational fraction_of(long double value) {
  const auto head = static_cast<double>(value);
  const auto rest = static_cast<double>(value - static_cast<long double>(head));
  return Rational(head) + Rational(rest);
}

ConstraintReport judge(const Condition& condition) {
  const Rational margin = condition.sense == Sense::kAtMost
                              ? Rational(condition.limit - condition.value)
                              : Rational(condition.value - condition.limit);
  const bool satisfied = condition.sense == Sense::kMoreThan ? margin > 0 : margin >= 0;
  return {condition.name,
          condition.key,
          condition.value.get_d(),
          condition.limit.get_d(),
          margin.get_d(),
          condition.unit,
          satisfied,
          sentence_of(condition, margin, satisfied)};
}

ConstraintReport violated_without_value(const Condition& condition, const std::string& reason) {
  return {condition.name, condition.key,  0.0,   condition.limit.get_d(),
          -1.0,           condition.unit, false, condition.name + ": " + reason};
}

}  // namespace torquewright::gearbox
