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

std::string with_unit_to(int digits, const Rational& value, const std::string& unit) {
  const std::string number = value.get_den() == 1
                                 ? value.get_num().get_str()
                                 : fmt::format("{:.{}g}", io::nearest(value), digits);
  if (unit == "1") return number;
  if (unit == "teeth" && abs(value) == 1) return number + " tooth";
  return fmt::format("{} {}", number, unit);
}

/// "at least 0.26 rad are asked for", "at most 1 is allowed".
std::string limit_clause(const DesignCondition& condition) {
  return fmt::format("{} {} {} {}", wording(condition.sense),
                     with_unit(condition.limit, condition.unit),
                     condition.unit == "1" ? "is" : "are",
                     condition.sense == Sense::kAtMost ? "allowed" : "asked for");
}

std::string margin_clause(const DesignCondition& condition, const Rational& margin,
                          bool satisfied) {
  if (satisfied && margin == 0) return "met exactly.";
  const std::string difference = with_unit_to(3, Rational(abs(margin)), condition.unit);
  if (satisfied) return difference + " to spare.";
  const std::string_view lack = condition.sense == Sense::kAtMost ? "too much" : "missing";
  if (condition.remedy.empty()) return fmt::format("{} {}.", difference, lack);
  return fmt::format("{} {}; {}.", difference, lack, condition.remedy);
}

std::string sentence_of(const DesignCondition& condition, const Rational& margin, bool satisfied) {
  return fmt::format("{}: {} {}; {}: {}", condition.name,
                     with_unit(condition.value, condition.unit), condition.meaning,
                     limit_clause(condition), margin_clause(condition, margin, satisfied));
}

}  // namespace

std::string with_unit(const Rational& value, const std::string& unit) {
  return with_unit_to(4, value, unit);
}

Rational fraction_of(long double value) {
  const auto head = static_cast<double>(value);
  const auto rest = static_cast<double>(value - static_cast<long double>(head));
  return Rational(head) + Rational(rest);
}

ConstraintReport judge(const DesignCondition& condition) {
  const Rational margin = condition.sense == Sense::kAtMost
                              ? Rational(condition.limit - condition.value)
                              : Rational(condition.value - condition.limit);
  const bool satisfied = condition.sense == Sense::kMoreThan ? margin > 0 : margin >= 0;
  return {condition.name,
          condition.key,
          io::nearest(condition.value),
          io::nearest(condition.limit),
          io::nearest(margin),
          condition.unit,
          satisfied,
          sentence_of(condition, margin, satisfied)};
}

ConstraintReport violated_without_value(const DesignCondition& condition,
                                        const std::string& reason) {
  return {condition.name, condition.key,  0.0,   io::nearest(condition.limit),
          -1.0,           condition.unit, false, condition.name + ": " + reason};
}

}  // namespace torquewright::gearbox
