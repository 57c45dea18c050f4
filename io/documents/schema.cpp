// SPDX-License-Identifier: Apache-2.0
#include "io/documents/schema.hpp"

#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "io/documents/embedded_schemas.hpp"

namespace torquewright::io {
namespace {

using nlohmann::json;

struct Kind {
  json text;
  valijson::Schema compiled;
};

std::string_view text_of(std::string_view kind) {
  for (const EmbeddedSchema& schema : embedded_schemas()) {
    if (schema.kind == kind) return schema.text;
  }
  throw std::invalid_argument("no schema for documents of kind " + std::string(kind));
}

template <typename Json>
Json load(std::string_view kind);

/// Replaces {"$ref": "other_kind.json"} by that schema. (References inside one file stay.)
template <typename Json>
void inline_other_kinds(Json& node) {
  if (node.is_object() && node.contains("$ref")) {
    const std::string reference = node["$ref"];
    if (!reference.ends_with(".json")) return;
    Json other = load<Json>(reference.substr(0, reference.size() - 5));
    if (node.contains("description")) other["description"] = node["description"];
    node = std::move(other);
    return;
  }
  if (!node.is_structured()) return;
  for (Json& child : node) inline_other_kinds(child);
}

template <typename Json>
Json load(std::string_view kind) {
  Json schema = Json::parse(text_of(kind));
  inline_other_kinds(schema);
  return schema;
}

/// Without what says nothing of a document's shape. The validator would look for the "$id".
json checked_part(json schema) {
  schema.erase("$id");
  schema.erase("examples");
  for (auto& [key, child] : schema["properties"].items()) {
    if (child.contains("$id")) child = checked_part(child);
  }
  return schema;
}

/// Each is read and compiled when it is first asked for: most commands need one or two of them.
const Kind& find_kind(std::string_view name) {
  static std::mutex mutex;
  static std::map<std::string, Kind, std::less<>> kinds;  // whose entries stay where they are
  const std::lock_guard lock(mutex);
  if (const auto known = kinds.find(name); known != kinds.end()) return known->second;
  json text = checked_part(load<json>(name));
  Kind& kind = kinds[std::string(name)];
  kind.text = std::move(text);
  valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
  parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(kind.text), kind.compiled);
  return kind;
}

}  // namespace

std::vector<std::string> document_kinds() {
  std::vector<std::string> kinds;
  for (const EmbeddedSchema& schema : embedded_schemas()) kinds.emplace_back(schema.kind);
  return kinds;
}

const json& schema_of(std::string_view kind) { return find_kind(kind).text; }

nlohmann::ordered_json schema_as_written(std::string_view kind) {
  return load<nlohmann::ordered_json>(kind);
}

bool conforms(const json& document, std::string_view kind) {
  valijson::Validator validator(valijson::Validator::kStrongTypes);
  return validator.validate(find_kind(kind).compiled,
                            valijson::adapters::NlohmannJsonAdapter(document), nullptr);
}

}  // namespace torquewright::io
