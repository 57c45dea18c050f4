// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "actuator/actuator_spec.hpp"
#include "actuator/exporters/exporter.hpp"

namespace torquewright::cli {

/// What `actuator mor --format` takes: csv, json and the name of every exporter.
std::vector<std::string> mor_formats();

/// A simulator's file, and the same with all that is known of it.
struct Exported {
  std::string text;
  nlohmann::ordered_json json;
};

/// Throws io::SpecError where the region is empty at rest: there is nothing to write.
Exported exported_file(const actuator::ReadActuator& read, const actuator::Conditions& conditions,
                       const actuator::Region& region, double table_accuracy,
                       const actuator::Exporter& exporter, actuator::Fit fit);

}  // namespace torquewright::cli
