// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/signals/channel_grid.hpp"
#include "identification/signals/signals.hpp"

namespace torquewright::identification {

/// Reads position, velocity and acceleration of a joint's output from the best channels: the
/// output's position before the motor's, a position before a velocity. From velocities alone the
/// position starts at 0. In a map without time velocity and acceleration are 0. `unfiltered_rad`
/// receives the position before the filter where it is asked for; empty without a position.
JointMotion read_motion(ChannelGrid& grid, const actuator::Actuator& actuator,
                        std::vector<double>* unfiltered_rad = nullptr);

}  // namespace torquewright::identification
