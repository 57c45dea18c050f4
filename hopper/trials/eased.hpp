// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/trials/randomisation.hpp"

namespace torquewright::hopper {

/// A share, 0 to 1, of what a randomisation says of bodies, ground, gains, latency and sensors: its
/// ranges shrink towards what the robot's document has, noise with them. What it says of supply,
/// windings and start stays: a policy that has not met a voltage fails at it, and learns it as
/// easily. A share of 1 changes nothing.
Randomisation eased(Randomisation randomisation, const Robot& robot, double share);

}  // namespace torquewright::hopper
