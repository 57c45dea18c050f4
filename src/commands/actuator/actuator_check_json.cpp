// SPDX-License-Identifier: Apache-2.0
#include "src/commands/actuator/actuator_check_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "actuator/check/check_report_spec.hpp"
#include "src/commands/actuator/check_options_json.hpp"
#include "src/commands/shared/result_json.hpp"

namespace torquewright::cli {
namespace {

/// What was asked for beyond the files, where it is not the default.
nlohmann::ordered_json options_json(const CheckOptions& options) {
  nlohmann::ordered_json json =
      check_options_json(options.columns, options.window, options.operating);
  // The command line lets "nan" pass, which states no condition.
  for (const char* key : {"bus_voltage_V", "state_of_charge", "winding_temperature_K"}) {
    if (json.contains(key) && std::isnan(json[key].get<double>())) json.erase(key);
  }
  if (options.torque_includes_inertia) json["torque_includes_inertia"] = true;
  if (options.torque_excludes_inertia) json["torque_includes_inertia"] = false;
  if (options.runs != 1) json["repeat"] = options.runs;
  if (options.pause_s != 0.0) json["pause_s"] = options.pause_s;
  return json;
}

}  // namespace

std::string actuator_check_json(const CheckOptions& options, const ActuatorCheckInputs& inputs,
                                const actuator::CheckReport& report) {
  nlohmann::ordered_json document = actuator::check_report_json(report);
  document["options"] = options_json(options);
  std::vector<io::Document> read{{options.trajectory_file, "", {}, report.sha256}};
  read.insert(read.end(), inputs.documents.begin(), inputs.documents.end());
  return result_text(std::move(document), read);
}

}  // namespace torquewright::cli
