// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "actuator/exporters/exporter.hpp"
#include "actuator/motor/actuator_spec.hpp"

namespace torquewright::cli {

/// A simulator's file; as_json: the same with all that is known of it, a document of kind
/// simulator_file. Throws io::SpecError where the region is empty at rest: there is nothing to
/// write.
std::string exported_file(const actuator::ReadActuator& read,
                          const actuator::OperatingConditions& conditions,
                          const actuator::Region& region, double table_accuracy,
                          const actuator::Exporter& exporter, actuator::LawFit fit, bool as_json);

}  // namespace torquewright::cli
