// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/preparation/channel_grid.hpp"
#include "identification/signals/bench.hpp"
#include "identification/signals/direction.hpp"
#include "identification/signals/signals.hpp"

namespace torquewright::identification {

/// Reads position, velocity and acceleration of a joint's output from the best channels: the
/// output's position before the motor's, a position before a velocity, but for `by_velocity`
/// (Bench::moves_by_velocity). From velocities alone the position starts at 0. In a map without
/// time velocity and acceleration are 0. `raw` receives what the speed comes from before the
/// filter, where it is asked for; empty in a map, and from velocities alone.
JointMotion read_motion(ChannelGrid& grid, const actuator::Actuator& actuator,
                        bool by_velocity = false, RawMotion* raw = nullptr);

/// Whether a shaft's logged velocity tells its speed better than the derivative of its position: in
/// the band of 8 Hz its noise is less than a third of that which differentiating leaves, and
/// neither its scale nor its instant is seen to differ from the position's. A velocity that a drive
/// has made of the same position shows the delay of its filter there.
bool tells_motion_better(const Log& log, const Bench& bench, const NoiseLevels& levels);

}  // namespace torquewright::identification
