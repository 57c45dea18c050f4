// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "dynamics/serial_arm.hpp"
#include "identification/rig/rig.hpp"
#include "simulation/plant.hpp"

namespace torquewright::identification {

/// Returns the links of a serial arm.
std::vector<dynamics::SerialLink> serial_links_of(const Load& load);

/// Returns the plant that the actuators of a rig move, from the stated load.
std::unique_ptr<simulation::Plant> plant_of(const Load& load);

}  // namespace torquewright::identification
