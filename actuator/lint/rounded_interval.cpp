// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/rounded_interval.hpp"

#include <charconv>
#include <cmath>
#include <string_view>

namespace torquewright::actuator::lint {
namespace {

/// Of the larger magnitude: what a few roundings of the arithmetic can move a bound by.
constexpr double kRoundOff = 1e-12;

double slack(double one, double other) {
  return kRoundOff * std::max(std::abs(one), std::abs(other));
}

}  // namespace

double half_unit(double value) {
  if (value == 0.0) return 0.0;
  char digits[512];
  const auto end =
      std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed).ptr;
  const std::string_view text(digits, static_cast<std::size_t>(end - digits));
  const std::size_t point = text.find('.');
  const std::size_t decimals = point == std::string_view::npos ? 0 : text.size() - point - 1;
  return 0.5 / std::pow(10.0, static_cast<double>(decimals));
}

RoundedInterval rounded(double value, std::string pointer) {
  const double half = half_unit(value);
  return {value, value - half, value + half, {std::move(pointer)}};
}

RoundedInterval exact(double value, std::string pointer) {
  RoundedInterval interval{value, value, value, {}};
  if (!pointer.empty()) interval.pointers.push_back(std::move(pointer));
  return interval;
}

bool is_one_sided(const RoundedInterval& interval) {
  const bool has_no_end = std::isinf(interval.high);
  return has_no_end != (interval.low <= 0.0 && interval.value > 0.0);
}

bool lies_above(const RoundedInterval& one, const RoundedInterval& other) {
  return one.low > other.high + slack(one.low, other.high);
}

bool overlap(const RoundedInterval& one, const RoundedInterval& other) {
  return !lies_above(one, other) && !lies_above(other, one);
}

std::vector<std::string> united(std::vector<std::string> pointers,
                                const std::vector<std::string>& more) {
  for (const std::string& pointer : more) {
    if (std::find(pointers.begin(), pointers.end(), pointer) == pointers.end()) {
      pointers.push_back(pointer);
    }
  }
  return pointers;
}

}  // namespace torquewright::actuator::lint
