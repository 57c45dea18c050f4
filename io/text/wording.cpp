// SPDX-License-Identifier: Apache-2.0
#include "io/text/wording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace torquewright::io {
namespace {

using nlohmann::json;

constexpr std::size_t kLongestQuote = 60;

struct TypeWords {
  std::string_view type;  ///< As in a schema.
  std::string_view one;
  std::string_view many;
};

constexpr TypeWords kTypeWords[] = {
    {"number", "a number", "numbers"}, {"integer", "a whole number", "whole numbers"},
    {"string", "a string", "strings"}, {"boolean", "true or false", "true or false"},
    {"array", "a list", "lists"},      {"object", "an object", "objects"},
    {"null", "null", "null"},
};

const TypeWords& words_of(std::string_view type) {
  const auto* found = std::find_if(std::begin(kTypeWords), std::end(kTypeWords),
                                   [&](const TypeWords& words) { return words.type == type; });
  if (found == std::end(kTypeWords)) throw std::invalid_argument("unknown type in a schema");
  return *found;
}

std::vector<std::string> types_of(const json& schema) {
  const auto type = schema.find("type");
  if (type == schema.end()) return {};
  if (type->is_string()) return {type->get<std::string>()};
  return type->get<std::vector<std::string>>();
}

bool is_of(const json& value, std::string_view type) {
  if (type == "integer") return value.is_number_integer();
  if (type == "number") return value.is_number();
  return words_of(type).one == type_name(value);
}

std::string joined(const std::vector<std::string>& words, std::string_view last_separator) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? last_separator : std::string_view(", ");
    text += words[i];
  }
  return text;
}

}  // namespace

std::string as_written(const json& value) {
  if (value.is_array() && !value.empty()) return "[...]";
  if (value.is_object() && !value.empty()) return "{...}";
  std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  if (text.size() <= kLongestQuote) return text;
  std::size_t cut = kLongestQuote;
  while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0) == 0x80) --cut;  // whole letters
  return text.substr(0, cut) + "...\"";
}

std::string type_name(const json& value) {
  if (value.is_number()) return "a number";
  if (value.is_string()) return "a string";
  if (value.is_boolean()) return "true or false";
  if (value.is_array()) return "a list";
  if (value.is_object()) return "an object";
  return "null";
}

std::string expected_type(const json& schema) {
  std::vector<std::string> words;
  for (const std::string& type : types_of(schema)) {
    const json items = schema.value("items", json());
    const auto of = items.is_object() ? types_of(items) : std::vector<std::string>{};
    const bool names_items = type == "array" && of.size() == 1;
    words.push_back(names_items ? fmt::format("a list of {}", words_of(of.front()).many)
                                : std::string(words_of(type).one));
  }
  return either(words);
}

bool has_expected_type(const json& value, const json& schema) {
  const std::vector<std::string> types = types_of(schema);
  return types.empty() || std::any_of(types.begin(), types.end(),
                                      [&](const std::string& type) { return is_of(value, type); });
}

std::string listed(const std::vector<std::string>& words) { return joined(words, ", "); }

std::string either(const std::vector<std::string>& words) { return joined(words, " or "); }

}  // namespace torquewright::io
