// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "dynamics/serial_arm.hpp"
#include "dynamics/tree.hpp"
#include "identification/rig/rig.hpp"
#include "simulation/plant.hpp"

namespace torquewright::identification {

/// Returns the links of a serial arm.
std::vector<dynamics::SerialLink> serial_links_of(const Load& load);

/// Returns the bodies of a robot's load, their base as it was turned.
dynamics::Tree robot_tree_of(const Load& load);

/// Returns the positions of a robot's joints (n x 1 of the tree): those that are held, 0 elsewhere.
Eigen::VectorXd held_positions_of(const Load& load);

/// Returns the plant that the actuators of a rig move, from the stated load.
std::unique_ptr<simulation::Plant> plant_of(const Load& load);

}  // namespace torquewright::identification
