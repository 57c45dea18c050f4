// SPDX-License-Identifier: Apache-2.0
#include "tests/gearbox/proof/mutation.hpp"

#include <algorithm>

namespace torquewright::gearbox::proof_test {
namespace {

using Json = nlohmann::json;
using Visit = std::function<void(const Mutation&)>;

class Mutator {
 public:
  Mutator(const std::vector<std::string>& words, const Visit& visit)
      : words_(words), visit_(visit) {}

  void mutate(Json& json, const std::string& pointer) {
    if (json.is_number()) mutate_number(json, pointer);
    if (json.is_string()) mutate_string(json, pointer);
    if (json.is_boolean()) try_value(json, !json.get<bool>(), pointer, "flip");
    if (json.is_null()) try_value(json, 1, pointer, "replace null");
    if (json.is_array()) mutate_array(json, pointer);
    if (json.is_object()) mutate_object(json, pointer);
  }

 private:
  void try_value(Json& json, const Json& value, const std::string& pointer,
                 const std::string& kind) {
    if (json == value) return;
    const Json before = json;
    json = value;
    visit_({pointer, kind});
    json = before;
  }

  void mutate_number(Json& json, const std::string& pointer) {
    if (json.is_number_integer()) {
      const long value = json;
      try_value(json, value + 1, pointer, "add 1");
      try_value(json, value - 1, pointer, "subtract 1");
      try_value(json, -value, pointer, "negate");
    } else {
      const double value = json;
      try_value(json, value + 1, pointer, "add 1");
      try_value(json, value - 1, pointer, "subtract 1");
      try_value(json, -value, pointer, "negate");
    }
    try_value(json, json.get<double>() * (1 + 1e-6), pointer, "add a millionth");
    try_value(json, 0, pointer, "set to zero");
  }

  /// In a node each string has its own vocabulary; any other word is as wrong as the next.
  std::vector<std::string> words_for(const std::string& pointer) const {
    if (pointer.find("/nodes/") == std::string::npos) return words_;
    const std::string last = pointer.substr(pointer.rfind('/') + 1);
    if (last == "closed") return {"empty", "enumerated", "relaxation", "open", "optimal"};
    const bool in_cut = pointer.find("/cuts/") != std::string::npos;
    if (in_cut && last == "2") return {"min", "max", "sun"};
    const bool variable = (in_cut && last == "1") || pointer.find("/split/") != std::string::npos;
    if (variable) return {"sun", "planet_1", "planet_2", "difference", "planet", "ratio"};
    return words_;
  }

  void mutate_string(Json& json, const std::string& pointer) {
    for (const std::string& word : words_for(pointer)) {
      try_value(json, word, pointer, "say " + word);
    }
  }

  void mutate_array(Json& json, const std::string& pointer) {
    for (std::size_t i = 0; i < json.size(); ++i) {
      const std::string place = pointer + "/" + std::to_string(i);
      mutate(json[i], place);
      Json dropped = json;
      dropped.erase(i);
      try_value(json, dropped, place, "drop element");
      Json doubled = json;
      doubled.insert(doubled.begin() + static_cast<std::ptrdiff_t>(i), json[i]);
      try_value(json, doubled, place, "double element");
      if (i + 1 == json.size()) continue;
      Json swapped = json;
      std::swap(swapped[i], swapped[i + 1]);
      try_value(json, swapped, place, "swap with next");
    }
  }

  void mutate_object(Json& json, const std::string& pointer) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : json.items()) keys.push_back(key);
    for (const std::string& key : keys) {
      mutate(json[key], pointer + "/" + key);
      Json removed = json;
      removed.erase(key);
      try_value(json, removed, pointer + "/" + key, "remove key");
    }
    Json enlarged = json;
    enlarged["unknown"] = 1;
    try_value(json, enlarged, pointer, "add key");
  }

  const std::vector<std::string>& words_;
  const Visit& visit_;
};

}  // namespace

void for_each_mutation(Json& document, const std::vector<std::string>& words, const Visit& visit) {
  Mutator(words, visit).mutate(document, "");
}

}  // namespace torquewright::gearbox::proof_test
