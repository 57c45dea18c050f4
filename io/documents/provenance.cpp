// SPDX-License-Identifier: Apache-2.0
#include "io/documents/provenance.hpp"

#include <nlohmann/json.hpp>

#include "io/documents/document.hpp"
#include "io/text/one_line.hpp"

namespace torquewright::io {

std::string_view tool_version() { return TORQUEWRIGHT_VERSION; }

nlohmann::json tool_provenance() { return {{"name", "torquewright"}, {"version", tool_version()}}; }

nlohmann::json input_provenance(std::span<const Document> documents) {
  nlohmann::json inputs = nlohmann::json::array();
  for (const Document& document : documents) {
    inputs.push_back({{"path", name_in_text(document.file)}, {"sha256", document.sha256}});
  }
  return inputs;
}

}  // namespace torquewright::io
