// SPDX-License-Identifier: Apache-2.0
#include "actuator/trajectory/columns_spec.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/documents/document.hpp"
#include "io/text/units.hpp"
#include "io/text/wording.hpp"

namespace torquewright::actuator {

std::vector<ColumnMapping> read_columns(const io::Document& document) {
  std::vector<ColumnMapping> mappings;
  std::vector<io::Fault> faults;
  std::size_t index = 0;
  for (const nlohmann::json& entry : document.root["columns"]) {
    const std::string path = fmt::format("{}/columns/{}", document.path, index++);
    const auto report = [&](const char* key, std::string message) {
      faults.push_back({document.file, path + key, std::move(message)});
    };
    const auto quantity = find_quantity(entry["quantity"].get<std::string>());
    if (!quantity) continue;  // of whole-body motions
    ColumnMapping mapping{entry["column"], entry.value("joint", ""), *quantity,
                          entry.value("factor", 1.0),
                          entry.contains("factor") || entry.contains("unit")};
    const bool is_time = mapping.quantity == Quantity::kTime;
    if (is_time != mapping.joint.empty()) {
      report("/joint", is_time ? "time is no joint's; leave it out" : "missing; whose quantity?");
    }
    if (mapping.factor == 0.0) report("/factor", kNoFactor);
    if (entry.contains("unit")) {
      const std::string name = entry["unit"];
      const io::Dimension dimension = dimension_of(mapping.quantity);
      const std::optional<io::Unit> unit = io::find_unit(name);
      if (unit && unit->dimension == dimension) {
        mapping.factor *= unit->in_SI;
      } else {
        report("/unit",
               fmt::format("\"{}\" is no unit of {}, which must be {}", name,
                           name_of(mapping.quantity), io::either(io::unit_names(dimension))));
      }
    }
    mappings.push_back(std::move(mapping));
  }
  if (!faults.empty()) throw io::SpecError(std::move(faults));
  return mappings;
}

}  // namespace torquewright::actuator
