// SPDX-License-Identifier: Apache-2.0
#include "src/commands/actuator/check_options_json.hpp"

#include <nlohmann/json.hpp>

namespace torquewright::cli {

nlohmann::ordered_json check_options_json(const std::vector<std::string>& columns,
                                          const WindowOptions& window,
                                          const OperatingOptions& operating) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (!columns.empty()) json["column"] = columns;
  if (!window.from_s.empty()) json["from_s"] = window.from_s.back();
  if (!window.until_s.empty()) json["until_s"] = window.until_s.back();
  const OperatingOptions usual;
  const auto add = [&json](const char* key, const auto& value, const auto& unless) {
    if (value != unless) json[key] = value;
  };
  add("rating", operating.rating, usual.rating);
  add("bus_voltage_V", operating.bus_voltage_V, usual.bus_voltage_V);
  add("state_of_charge", operating.state_of_charge, usual.state_of_charge);
  add("winding_temperature_K", operating.winding_temperature_K, usual.winding_temperature_K);
  return json;
}

}  // namespace torquewright::cli
