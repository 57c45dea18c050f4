// SPDX-License-Identifier: Apache-2.0
#include "src/commands/shared/fingerprint_json.hpp"

#include <nlohmann/json.hpp>

#include "io/documents/provenance.hpp"
#include "io/faults/json_text.hpp"
#include "io/files/sha256.hpp"

namespace torquewright::cli {

std::string fingerprint(std::string_view command, const nlohmann::ordered_json& options,
                        std::span<const io::Document> inputs) {
  nlohmann::ordered_json all{{"command", command}, {"options", options}};
  all["tool"] = io::tool_provenance();
  all["inputs"] = nlohmann::ordered_json::array();
  for (const io::Document& input : inputs) all["inputs"].push_back(input.sha256);
  return io::sha256(io::json_text(all));
}

}  // namespace torquewright::cli
