// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "actuator/exporters/exporter.hpp"
#include "actuator/motor/actuator_spec.hpp"

namespace torquewright::cli {

/// A simulator's file, and the same with all that is known of it.
struct Exported {
  std::string text;
  nlohmann::ordered_json json;
};

/// Throws io::SpecError where the region is empty at rest: there is nothing to write.
Exported exported_file(const actuator::ReadActuator& read,
                       const actuator::OperatingConditions& conditions,
                       const actuator::Region& region, double table_accuracy,
                       const actuator::Exporter& exporter, actuator::LawFit fit);

}  // namespace torquewright::cli
