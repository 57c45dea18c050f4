// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "actuator/exporters/exporter.hpp"

namespace torquewright::hopper {

/// A simulator whose robots a module of Python holds to the regions of all their drives. One file
/// each in this folder, one line in every_region_module.hpp.
struct RegionModule {
  const actuator::Exporter* exporter;  ///< Of one drive: its name, source, friction and law.
  std::string_view source;             ///< Where the calls for a whole robot are documented.
  std::string_view advice;             ///< Sentences.
  std::string_view functions;          ///< Python behind the tables, of which it speaks.
  bool holds_springs = false;          ///< By the robot's own file; else the functions do.
};

}  // namespace torquewright::hopper
