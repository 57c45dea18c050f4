// SPDX-License-Identifier: Apache-2.0
#include "gearbox/proof/reading/json_reading.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

namespace torquewright::gearbox::proof {
namespace {

constexpr std::int64_t kGreatestWhole = std::int64_t{1} << 53;

/// Written here once more, so that the checker does not rest on the reading of numbers by others.
io::Rational exact_decimal(double value) {
  std::array<char, 64> numeral;
  const auto end = std::to_chars(numeral.data(), numeral.data() + numeral.size(), value,
                                 std::chars_format::scientific)
                       .ptr;
  std::string digits(numeral.data(), end);
  const std::size_t mark = digits.find('e');
  long exponent = std::strtol(digits.c_str() + mark + 1, nullptr, 10);
  digits.resize(mark);
  const std::size_t point = digits.find('.');
  if (point != std::string::npos) {
    exponent -= static_cast<long>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(exponent)));
  io::Rational result{mpz_class(digits, 10)};
  if (exponent < 0) return result / power;
  return result * power;
}

}  // namespace

const Json* member(const Json& json, std::string_view key) {
  if (!json.is_object()) return nullptr;
  const auto found = json.find(key);
  return found == json.end() ? nullptr : &*found;
}

const Json* present(const Json& json, std::string_view key) {
  const Json* value = member(json, key);
  return value == nullptr || value->is_null() ? nullptr : value;
}

const Json& elements(const Json* json) {
  static const Json none = Json::array();
  return json != nullptr && json->is_array() ? *json : none;
}

std::optional<std::string> text(const Json* json) {
  if (json == nullptr || !json->is_string()) return std::nullopt;
  return json->get<std::string>();
}

std::optional<std::int64_t> whole_number(const Json* json) {
  if (json == nullptr || !json->is_number_integer()) return std::nullopt;
  if (json->is_number_unsigned() &&
      json->get<std::uint64_t>() > static_cast<std::uint64_t>(kGreatestWhole)) {
    return std::nullopt;
  }
  const auto value = json->get<std::int64_t>();
  if (value < -kGreatestWhole || value > kGreatestWhole) return std::nullopt;
  return value;
}

std::optional<io::Rational> decimal(const Json* json) {
  if (json == nullptr || !json->is_number()) return std::nullopt;
  if (json->is_number_integer()) {
    const auto value = whole_number(json);
    if (!value) return std::nullopt;
    return io::Rational(static_cast<long>(*value));
  }
  const auto value = json->get<double>();
  if (!std::isfinite(value)) return std::nullopt;
  return exact_decimal(value);
}

void check_keys(const Json& json, std::initializer_list<std::string_view> known,
                const std::string& place, Faults& faults) {
  if (!json.is_object()) {
    faults.add(place, "is no object");
    return;
  }
  for (const auto& [key, value] : json.items()) {
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      faults.add(place + "/" + pointer_part(key), "is no key of this part of a certificate");
    }
  }
}

std::string pointer_part(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  std::string part;
  for (const char character : text.substr(0, kLongest)) {
    if (character == '~') {
      part += "~0";
    } else if (character == '/') {
      part += "~1";
    } else {
      part += character;
    }
  }
  return part;
}

}  // namespace torquewright::gearbox::proof
