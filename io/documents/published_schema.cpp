// SPDX-License-Identifier: Apache-2.0
#include "io/documents/published_schema.hpp"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "io/documents/json_layout.hpp"
#include "io/documents/schema.hpp"
#include "io/documents/usual_part.hpp"
#include "io/faults/json_text.hpp"

namespace torquewright::io {

std::string published_schema(std::string_view kind) { return json_text(schema_as_written(kind)); }

std::string document_to_start_from(std::string_view kind, std::size_t number, StartKeys keys) {
  const nlohmann::ordered_json schema = schema_as_written(kind);
  const bool has_one = schema.contains("examples") && number < schema["examples"].size();
  if (!has_one) return "";
  const nlohmann::ordered_json& whole = schema["examples"][number];
  if (keys == StartKeys::kAll) return json_layout(whole);
  return json_layout(
      usual_part(whole, schema.at("usually_stated").get<std::vector<std::string>>()));
}

KindOfDocument describe_kind(std::string_view kind) {
  const nlohmann::ordered_json schema = schema_as_written(kind);
  return {schema["title"], schema.value("description", ""), keys_of(schema)};
}

std::vector<SchemaKey> keys_in(const std::string& document, const std::vector<SchemaKey>& keys) {
  const auto root = nlohmann::ordered_json::parse(document);
  std::vector<SchemaKey> standing;
  std::copy_if(keys.begin(), keys.end(), std::back_inserter(standing),
               [&](const SchemaKey& key) { return stands_in(root, key.pointer); });
  return standing;
}

}  // namespace torquewright::io
