// SPDX-License-Identifier: Apache-2.0
#include "hopper/motion/mapping_spec.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "actuator/trajectory/columns_spec.hpp"
#include "io/documents/document.hpp"
#include "io/faults/spec_error.hpp"

namespace torquewright::hopper {

std::vector<actuator::MappingText> read_mappings(const io::Document& document) {
  std::vector<actuator::MappingText> mappings;
  std::vector<io::Fault> faults;
  for (const nlohmann::json& entry : document.root["columns"]) {
    const std::size_t index = mappings.size();
    mappings.push_back({entry["column"], entry.value("joint", ""), entry["quantity"],
                        entry.value("unit", ""), entry.value("factor", 1.0)});
    if (mappings.back().factor != 0.0) continue;
    faults.push_back({document.file, fmt::format("{}/columns/{}/factor", document.path, index),
                      actuator::kNoFactor});
  }
  if (!faults.empty()) throw io::SpecError(std::move(faults));
  return mappings;
}

}  // namespace torquewright::hopper
