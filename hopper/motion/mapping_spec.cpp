// SPDX-License-Identifier: Apache-2.0
#include "hopper/motion/mapping_spec.hpp"

#include <nlohmann/json.hpp>

#include "io/document.hpp"

namespace torquewright::hopper {

std::vector<actuator::MappingText> read_mappings(const io::Document& document) {
  std::vector<actuator::MappingText> mappings;
  for (const nlohmann::json& entry : document.root["columns"]) {
    mappings.push_back({entry["column"], entry.value("joint", ""), entry["quantity"],
                        entry.value("unit", ""), entry.value("factor", 1.0)});
  }
  return mappings;
}

}  // namespace torquewright::hopper
