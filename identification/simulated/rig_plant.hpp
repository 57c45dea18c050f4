// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "dynamics/serial_arm.hpp"
#include "identification/rig/rig.hpp"
#include "simulation/plant.hpp"

namespace torquewright::identification {

/// The links of a serial arm.
std::vector<dynamics::SerialLink> serial_links_of(const Load& load);

/// What the actuators of a rig move, by a load that its document states.
std::unique_ptr<simulation::Plant> plant_of(const Load& load);

}  // namespace torquewright::identification
