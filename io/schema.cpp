// SPDX-License-Identifier: Apache-2.0
#include "io/schema.hpp"

#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "io/embedded_schemas.hpp"

namespace torquewright::io {
namespace {

using nlohmann::json;

struct Kind {
  json text;
  valijson::Schema compiled;
};

json load(std::string_view kind);

/// Replaces {"$ref": "other_kind.json"} by that schema. (References inside one file stay.)
void inline_other_kinds(json& node) {
  if (node.is_object() && node.contains("$ref")) {
    const std::string reference = node["$ref"];
    if (reference.ends_with(".json")) node = load(reference.substr(0, reference.size() - 5));
    return;
  }
  if (!node.is_structured()) return;
  for (json& child : node) inline_other_kinds(child);
}

json load(std::string_view kind) {
  for (const EmbeddedSchema& schema : embedded_schemas()) {
    if (schema.kind != kind) continue;
    json text = json::parse(schema.text);
    inline_other_kinds(text);
    return text;
  }
  throw std::invalid_argument("no schema for documents of kind " + std::string(kind));
}

/// Each is read and compiled when it is first asked for: most commands need one or two of them.
const Kind& find_kind(std::string_view name) {
  static std::mutex mutex;
  static std::map<std::string, Kind, std::less<>> kinds;  // whose entries stay where they are
  const std::lock_guard lock(mutex);
  if (const auto known = kinds.find(name); known != kinds.end()) return known->second;
  json text = load(name);
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

bool conforms(const json& document, std::string_view kind) {
  valijson::Validator validator(valijson::Validator::kStrongTypes);
  return validator.validate(find_kind(kind).compiled,
                            valijson::adapters::NlohmannJsonAdapter(document), nullptr);
}

}  // namespace torquewright::io
