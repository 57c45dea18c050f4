// SPDX-License-Identifier: Apache-2.0
#include "gearbox/verification/difference_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/faults/json_text.hpp"

namespace torquewright::gearbox {
namespace {

using Json = nlohmann::json;

constexpr double kRelativeTolerance = 1e-9;
constexpr double kAbsoluteTolerance = 1e-14;

/// A whole number stands for a fraction that happens to be whole, but not the other way round.
bool equal_numbers(const Json& found, const Json& expected) {
  if (expected.is_number_integer()) return found.is_number_integer() && found == expected;
  const double a = found.get<double>();
  const double b = expected.get<double>();
  const double tolerance =
      std::max(kAbsoluteTolerance, kRelativeTolerance * std::max(std::abs(a), std::abs(b)));
  return std::abs(a - b) <= tolerance;
}

std::string as_text(const Json& value) {
  constexpr std::size_t kLongest = 100;
  if (value.is_object()) return "an object";
  if (value.is_array()) return fmt::format("a list of {}", value.size());
  std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (text.size() > kLongest) text.replace(kLongest, std::string::npos, "...");
  return text;
}

Difference differing(const Json& found, const Json& expected, const std::string& pointer) {
  return {pointer, fmt::format("is {}, expected {}", as_text(found), as_text(expected))};
}

std::optional<Difference> objects(const Json& found, const Json& expected,
                                  const std::string& pointer) {
  for (const auto& [key, value] : expected.items()) {
    const std::string place = io::child_path(pointer, key);
    const auto member = found.find(key);
    if (member == found.end()) {
      return Difference{place, fmt::format("is missing, expected {}", as_text(value))};
    }
    if (auto difference = first_difference(*member, value, place)) return difference;
  }
  for (const auto& [key, value] : found.items()) {
    if (!expected.contains(key)) return Difference{io::child_path(pointer, key), "is no key here"};
  }
  return std::nullopt;
}

std::optional<Difference> arrays(const Json& found, const Json& expected,
                                 const std::string& pointer) {
  for (std::size_t i = 0; i < std::min(found.size(), expected.size()); ++i) {
    const std::string place = io::child_path(pointer, std::to_string(i));
    if (auto difference = first_difference(found[i], expected[i], place)) return difference;
  }
  if (found.size() == expected.size()) return std::nullopt;
  return differing(found, expected, pointer);
}

}  // namespace

std::optional<Difference> first_difference(const Json& found, const Json& expected,
                                           const std::string& pointer) {
  if (found.is_object() && expected.is_object()) return objects(found, expected, pointer);
  if (found.is_array() && expected.is_array()) return arrays(found, expected, pointer);
  const bool are_numbers = found.is_number() && expected.is_number();
  const bool are_equal = are_numbers ? equal_numbers(found, expected) : found == expected;
  if (are_equal) return std::nullopt;
  return differing(found, expected, pointer);
}

}  // namespace torquewright::gearbox
