// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "actuator/exporters/exporter.hpp"
#include "actuator/motor/actuator_spec.hpp"

namespace torquewright::cli {

/// A simulator's file; as_json: the same with all that is known of it, a document of kind
/// simulator_file. Throws io::SpecError where the region is empty at rest: there is nothing to
/// write.
std::string exported_file(const actuator::ReadActuator& read, const actuator::Exporter& exporter,
                          const actuator::ExportChoices& choices, bool as_json);

/// Where the friction is to stand, as --friction says (empty: nothing). Throws io::SpecError where
/// no joint of that simulator can have it.
actuator::FrictionPlace friction_place(const std::string& option,
                                       const actuator::Actuator& actuator,
                                       const actuator::Exporter& exporter, actuator::Side side);

}  // namespace torquewright::cli
