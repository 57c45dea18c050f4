// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "actuator/exporters/exporter.hpp"

namespace torquewright::actuator {

/// What a simulator adds to the module of Python that holds a region.
struct PythonParts {
  std::string methods;    ///< Of the class Region, indented.
  std::string functions;  ///< Behind REGION, of which they may speak; two blank lines in front.
  /// Friction at the joint is taken off by REGION.torque, else it is the simulator's joint's.
  bool composes_friction = false;
};

/// A region of a module that has the class Region (source_text/python_source.hpp), under a name.
struct PythonRegion {
  std::vector<std::string> notes;  ///< For the module's head.
  std::string text;                ///< One blank line in front.
};

/// `composes`: with torque(), for a class with friction, where the subject's friction is the
/// joint's.
PythonRegion python_region(std::string_view name, const Subject& subject,
                           std::span<const double> shape, bool composes);

/// A module of Python for whichever array library hands in its arrays: the region as tables, over
/// voltage and temperature where it has no gap, as REGION and its clip and limits; with composed
/// friction torque too. `shape` is that of table_shape(); `note` heads it as comments. N m, rad/s,
/// V, K, kg m^2.
std::string python_module(const Subject& subject, std::span<const double> shape,
                          const std::vector<std::string>& note, const PythonParts& parts);

}  // namespace torquewright::actuator
