// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace torquewright::actuator {

/// Methods of the class Region (python_source.hpp) that make it a clamping component of Newton's
/// actuators, and a configuration of Isaac Lab's native ones. `has_friction`: what it passes on is
/// what reaches the joint.
std::string python_newton(bool has_friction);

}  // namespace torquewright::actuator
