// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace torquewright::actuator {

/// The part of an exported Python module that no actuator changes: the class Region, open at its
/// end for methods of a simulator. `has_friction`: with what lies between the motor and the load.
std::string python_source(bool has_friction);

}  // namespace torquewright::actuator
