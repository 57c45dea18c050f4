// SPDX-License-Identifier: Apache-2.0
#include "io/text/stepped_range.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace torquewright::io {
namespace {

std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ':') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

[[noreturn]] void refuse(const RangeRule& rule, const std::string& why) {
  rule.refuse(why);
  throw std::logic_error("stepped range: its refusal did not throw");
}

Rational number_in(const std::string& text, const RangeRule& rule) {
  try {
    const Rational number = rational_from_numeral(text);
    if (std::isfinite(nearest(number))) return number;
  } catch (const std::invalid_argument&) {
    refuse(rule, fmt::format("\"{}\" is not a number", text));
  }
  refuse(rule, fmt::format("\"{}\" is beyond all numbers that are computed with", text));
}

}  // namespace

bool is_range(const std::string& text) { return text.find(':') != std::string::npos; }

Rational read_range_number(const std::string& text, const RangeRule& rule) {
  const Rational number = number_in(text, rule);
  if (number >= exact(rule.least) && number <= exact(rule.greatest)) return number;
  refuse(rule, fmt::format("{} are from {:g} to {:g}", rule.what, rule.least, rule.greatest));
}

SteppedRange read_stepped_range(const std::string& text, const RangeRule& rule) {
  const std::vector<std::string> parts = parts_of(text);
  if (parts.size() < 2 || parts.size() > 3) refuse(rule, "it is no range");
  SteppedRange range{read_range_number(parts[0], rule), read_range_number(parts[1], rule)};
  if (parts.size() == 3) range.step = number_in(parts[2], rule);
  if (range.step <= 0) refuse(rule, fmt::format("the step {} is not above 0", parts[2]));
  if (range.from > range.to) refuse(rule, fmt::format("{} lies above {}", parts[0], parts[1]));
  if ((range.to - range.from) / range.step >= rule.most) {
    refuse(rule, fmt::format("these are more than {} {}", rule.most, rule.what));
  }
  return range;
}

std::vector<Rational> values_of(const SteppedRange& range) {
  std::vector<Rational> values;
  for (Rational value = range.from; value <= range.to; value += range.step) {
    values.push_back(value);
  }
  return values;
}

}  // namespace torquewright::io
