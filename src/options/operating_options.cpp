// SPDX-License-Identifier: Apache-2.0
#include "src/options/operating_options.hpp"

#include "actuator/heat/working_temperature.hpp"
#include "src/options/echo_places.hpp"

namespace torquewright::cli {

void add_operating_options(command_line::Command& command, OperatingOptions& options) {
  command
      .add_option("--rating", options.rating,
                  "Which limits of the drive hold: peak (for seconds) or continuous")
      .one_of({"peak", "continuous"})
      .stated_as("rating", kInputsPlace);
  command
      .add_option("--bus-voltage", options.bus_voltage_V,
                  "Voltage of the source without load, in V")
      .otherwise("the document's")
      .between(0.5, 2000.0)
      .stated_as("bus_voltage_V", kInputsPlace);
  command
      .add_option("--state-of-charge", options.state_of_charge,
                  "How full the battery is: 0 is empty, 1 full")
      .otherwise("1")
      .between(0.0, 1.0)
      .stated_as("state_of_charge", kInputsPlace);
  command
      .add_option("--winding-temperature", options.winding_temperature_K,
                  "Temperature at which the windings work, in K")
      .otherwise("the document's")
      .between(actuator::kColdestWinding_K, actuator::kHottestWinding_K)
      .stated_as("winding_temperature_K", kInputsPlace);
}

actuator::OperatingConditions stated_conditions(const OperatingOptions& options) {
  actuator::OperatingConditions conditions;
  if (options.rating == "continuous") conditions.rating = actuator::Rating::kContinuous;
  if (options.bus_voltage_V > 0.0) conditions.bus_voltage_V = options.bus_voltage_V;
  if (options.state_of_charge >= 0.0) conditions.state_of_charge = options.state_of_charge;
  if (options.winding_temperature_K > 0.0) {
    conditions.winding_temperature_K = options.winding_temperature_K;
  }
  return conditions;
}

void require_possible(const actuator::Actuator& actuator, const std::string& file,
                      const actuator::OperatingConditions& conditions) {
  std::vector<io::Fault> faults;
  for (const std::string& sentence : actuator::objections(actuator, conditions)) {
    faults.push_back({file, "", sentence});
  }
  if (!faults.empty()) throw io::SpecError(std::move(faults));
}

actuator::OperatingConditions conditions_of(const OperatingOptions& options,
                                            const actuator::ReadActuator& read) {
  const actuator::OperatingConditions conditions = stated_conditions(options);
  require_possible(read.actuator, read.documents.front().file, conditions);
  return conditions;
}

}  // namespace torquewright::cli
