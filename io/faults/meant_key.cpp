// SPDX-License-Identifier: Apache-2.0
#include "io/faults/meant_key.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/faults/json_text.hpp"
#include "io/text/letter_case.hpp"
#include "io/text/nearest.hpp"

namespace torquewright::io {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

/// bus_voltage_V: bus, voltage, v.
Words words_of(const std::string& key) {
  Words words;
  std::istringstream stream(in_small_letters(key));
  for (std::string word; std::getline(stream, word, '_');) words.push_back(word);
  return words;
}

bool is_called(const json& property, const std::string& key) {
  const json names = property.value("also_called", json::array());
  return std::any_of(names.begin(), names.end(), [&](const json& name) {
    return in_small_letters(name) == in_small_letters(key);
  });
}

/// A letter alone says too little: "m" is in every length.
bool has_words_of(const std::string& key, const std::string& unknown) {
  const Words words = words_of(key), asked = words_of(unknown);
  const bool is_telling = std::any_of(asked.begin(), asked.end(),
                                      [](const std::string& word) { return word.size() > 3; });
  return is_telling && std::all_of(asked.begin(), asked.end(), [&](const std::string& word) {
           return std::find(words.begin(), words.end(), word) != words.end();
         });
}

const json& properties_of(const json& schema) {
  static const json kNone = json::object();
  const auto found = schema.find("properties");
  return found == schema.end() ? kNone : *found;
}

/// Missing ones alone where there are any among them.
Words missing_first(const Words& keys, const json& schema) {
  const json required = schema.value("required", json::array());
  Words missing;
  for (const std::string& key : keys) {
    if (std::find(required.begin(), required.end(), key) != required.end()) missing.push_back(key);
  }
  return missing.empty() ? keys : missing;
}

}  // namespace

Words known_keys(const json& schema) {
  Words keys;
  for (const auto& [key, property] : properties_of(schema).items()) {
    if (!key.starts_with('$')) keys.push_back(key);
  }
  return keys;
}

Words meant_keys(const std::string& key, const json& object, const json& schema) {
  Words open, with_its_words;
  for (const std::string& known : known_keys(schema)) {
    if (object.contains(known)) continue;
    if (is_called(properties_of(schema)[known], key)) return {known};
    open.push_back(known);
    if (has_words_of(known, key)) with_its_words.push_back(known);
  }
  if (!with_its_words.empty()) return missing_first(with_its_words, schema);
  auto near = nearest(key, open);
  if (!near) near = nearest(key, known_keys(schema));
  return near ? Words{*near} : Words{};
}

std::string place_of(const std::string& key, const json& root) {
  for (const auto& [name, property] : properties_of(root).items()) {
    if (is_called(property, key)) return child_path("", name);
    if (std::string below = place_of(key, property); !below.empty()) {
      return child_path("", name) + below;
    }
  }
  return "";
}

}  // namespace torquewright::io
