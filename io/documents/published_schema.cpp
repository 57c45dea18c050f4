// SPDX-License-Identifier: Apache-2.0
#include "io/documents/published_schema.hpp"

#include <nlohmann/json.hpp>

#include "io/documents/json_layout.hpp"
#include "io/documents/schema.hpp"
#include "io/faults/json_text.hpp"

namespace torquewright::io {

std::string published_schema(std::string_view kind) { return json_text(schema_as_written(kind)); }

std::string document_to_start_from(std::string_view kind, std::size_t number) {
  const nlohmann::ordered_json schema = schema_as_written(kind);
  const bool has_one = schema.contains("examples") && number < schema["examples"].size();
  return has_one ? json_layout(schema["examples"][number]) : "";
}

KindOfDocument describe_kind(std::string_view kind) {
  const nlohmann::ordered_json schema = schema_as_written(kind);
  return {schema["title"], schema.value("description", ""), keys_of(schema)};
}

}  // namespace torquewright::io
