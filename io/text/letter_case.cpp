// SPDX-License-Identifier: Apache-2.0
#include "io/text/letter_case.hpp"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

namespace torquewright::io {

std::string in_small_letters(std::string word) {
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return word;
}

namespace {

using nlohmann::json;

void take_listed_word(json& value, const json& choices) {
  if (std::find(choices.begin(), choices.end(), value) != choices.end()) return;
  for (const json& choice : choices) {
    if (!choice.is_string()) continue;
    if (in_small_letters(choice) == in_small_letters(value)) {
      value = choice;
      return;
    }
  }
}

void visit(json& value, const json& schema, const json& root);

void visit_list(json& list, const json& items, const json& root) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (items.is_object()) visit(list[i], items, root);
    if (items.is_array() && i < items.size()) visit(list[i], items[i], root);
  }
}

void visit_object(json& object, const json& schema, const json& root) {
  const auto properties = schema.find("properties");
  const auto others = schema.find("additionalProperties");
  for (auto& [key, child] : object.items()) {
    if (properties != schema.end() && properties->contains(key)) {
      visit(child, (*properties)[key], root);
    } else if (others != schema.end() && others->is_object()) {
      visit(child, *others, root);
    }
  }
}

void visit(json& value, const json& schema, const json& root) {
  if (!schema.is_object()) return;
  if (const auto reference = schema.find("$ref"); reference != schema.end()) {
    return visit(value, root.at(json::json_pointer(reference->get<std::string>().substr(1))), root);
  }
  if (const auto alternatives = schema.find("anyOf"); alternatives != schema.end()) {
    for (const json& alternative : *alternatives) visit(value, alternative, root);
  }
  if (value.is_string() && schema.contains("enum")) take_listed_word(value, schema["enum"]);
  if (value.is_array() && schema.contains("items")) visit_list(value, schema["items"], root);
  if (value.is_object()) visit_object(value, schema, root);
}

}  // namespace

void take_listed_capitals(json& document, const json& schema) { visit(document, schema, schema); }

}  // namespace torquewright::io
