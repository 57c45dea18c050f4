// SPDX-License-Identifier: Apache-2.0
#include "src/commands/shared/result_json.hpp"

#include <nlohmann/json.hpp>

#include "io/documents/provenance.hpp"
#include "io/faults/json_text.hpp"

namespace torquewright::cli {

void add_provenance(nlohmann::ordered_json& document, std::span<const io::Document> inputs) {
  document["tool"] = io::tool_provenance();
  document["inputs"] = io::input_provenance(inputs);
}

std::string result_text(nlohmann::ordered_json answer, std::span<const io::Document> inputs) {
  add_provenance(answer, inputs);
  return io::json_text(answer);
}

nlohmann::json as_read(const std::string& text) { return nlohmann::json::parse(text); }

}  // namespace torquewright::cli
