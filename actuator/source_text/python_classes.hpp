// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace torquewright::actuator {

/// Methods of the class Region (python_source.hpp) that configure actuators of Isaac Lab's and
/// mjlab's own classes, for the text of the class to go on with. `has_friction`: a command is the
/// motor's, and what they pass on is what reaches the joint.
std::string python_configurations_of(bool has_friction);

/// Those classes, behind REGION, as of the module.
std::string python_classes(bool has_friction);

}  // namespace torquewright::actuator
