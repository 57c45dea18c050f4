// SPDX-License-Identifier: Apache-2.0
#include "io/documents/schema_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "io/faults/json_text.hpp"
#include "io/text/wording.hpp"

namespace torquewright::io {
namespace {

using nlohmann::ordered_json;

/// Walks a schema and collects its keys.
class KeyList {
 public:
  explicit KeyList(const ordered_json& schema) : root_(schema) { visit(schema, ""); }

  std::vector<SchemaKey> take() { return std::move(keys_); }

 private:
  const ordered_json& referenced(const ordered_json& node) const {
    const std::string reference = node["$ref"];
    return root_.at(ordered_json::json_pointer(reference.substr(1)));
  }

  const ordered_json& resolved(const ordered_json& node) const {
    return node.contains("$ref") ? resolved(referenced(node)) : node;
  }

  /// What the node says under this keyword, or else what it refers to.
  std::string text(const ordered_json& node, const char* keyword) const {
    if (node.contains(keyword)) return node[keyword];
    return node.contains("$ref") ? text(referenced(node), keyword) : "";
  }

  /// Of a number, or of the numbers in a list or among alternatives.
  std::string unit(const ordered_json& node) const {
    if (std::string own = text(node, "unit"); !own.empty()) return own;
    const ordered_json& schema = resolved(node);
    if (schema.contains("items") && schema["items"].is_object()) return unit(schema["items"]);
    for (const ordered_json& alternative : schema.value("anyOf", ordered_json::array())) {
      if (std::string found = unit(alternative); !found.empty()) return found;
    }
    return "";
  }

  static std::string range(const ordered_json& schema) {
    const bool has_least = schema.contains("minimum"), has_most = schema.contains("maximum");
    const double least = schema.value("minimum", 0.0), most = schema.value("maximum", 0.0);
    if (has_least && has_most) return fmt::format(" from {} to {}", least, most);
    if (has_least) return fmt::format(" of {} or more", least);
    return has_most ? fmt::format(" of {} or less", most) : "";
  }

  static std::string size(const ordered_json& schema) {
    const bool has_least = schema.contains("minItems"), has_most = schema.contains("maxItems");
    if (has_least && has_most && schema["minItems"] == schema["maxItems"]) {
      return fmt::format(" of {}", schema["minItems"].dump());
    }
    if (has_least && has_most) {
      return fmt::format(" of {} to {}", schema["minItems"].dump(), schema["maxItems"].dump());
    }
    if (has_least) return fmt::format(" of {} or more", schema["minItems"].dump());
    return has_most ? fmt::format(" of up to {}", schema["maxItems"].dump()) : "";
  }

  static std::string choices(const ordered_json& values) {
    std::vector<std::string> words;
    for (const ordered_json& value : values) words.push_back(value.dump());
    return either(words);
  }

  std::string list(const ordered_json& schema) const {
    std::string words = "a list" + size(schema);
    if (!schema.contains("items") || !schema["items"].is_object()) return words;
    const ordered_json& entry = resolved(schema["items"]);
    if (!entry.contains("type") || !entry["type"].is_string()) return words;
    const nlohmann::json as_list = {{"type", "array"}, {"items", {{"type", entry["type"]}}}};
    words += expected_type(as_list).substr(std::string_view("a list").size());
    // "a list of 2 of numbers" is no English.
    if (const auto twice = words.rfind(" of "); !size(schema).empty()) words.erase(twice, 3);
    return words + (entry.contains("enum") ? ": " + choices(entry["enum"]) : range(entry));
  }

  std::string one_type(const ordered_json& schema, const std::string& type) const {
    if (type == "array") return list(schema);
    std::string words = expected_type({{"type", type}});
    return type == "number" || type == "integer" ? words + range(schema) : words;
  }

  std::string allowed(const ordered_json& node) const {
    if (node.contains("$id")) return "a whole document: " + node["title"].get<std::string>();
    const ordered_json& schema = resolved(node);
    if (schema.contains("const")) return schema["const"].dump();
    if (schema.contains("enum")) return choices(schema["enum"]);
    std::vector<std::string> words;
    for (const ordered_json& alternative : schema.value("anyOf", ordered_json::array())) {
      words.push_back(allowed(alternative));
    }
    if (!words.empty() || !schema.contains("type")) return either(words);
    if (schema["type"].is_string()) return one_type(schema, schema["type"]);
    for (const std::string type : schema["type"]) words.push_back(one_type(schema, type));
    return either(words);
  }

  void add(const ordered_json& node, const std::string& pointer, bool is_required) {
    if (!listed_.insert(pointer).second) return;
    keys_.push_back({pointer, allowed(node), unit(node), text(node, "description"), is_required});
  }

  void visit_properties(const ordered_json& schema, const std::string& pointer) {
    const ordered_json required = schema.value("required", ordered_json::array());
    for (const auto& [key, node] : schema["properties"].items()) {
      const std::string place = child_path(pointer, key);
      add(node, place, std::find(required.begin(), required.end(), key) != required.end());
      if (!node.contains("$id")) visit(node, place);
    }
  }

  void visit(const ordered_json& node, const std::string& pointer) {
    const ordered_json& schema = resolved(node);
    if (schema.contains("properties")) visit_properties(schema, pointer);
    for (const char* keyword : {"items", "additionalProperties"}) {
      if (schema.contains(keyword) && schema[keyword].is_object()) {
        visit(schema[keyword], pointer + "/*");
      }
    }
    for (const ordered_json& alternative : schema.value("anyOf", ordered_json::array())) {
      visit(alternative, pointer);
    }
  }

  const ordered_json& root_;
  std::set<std::string> listed_;
  std::vector<SchemaKey> keys_;
};

}  // namespace

std::vector<SchemaKey> keys_of(const ordered_json& schema) { return KeyList(schema).take(); }

}  // namespace torquewright::io
