// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/motion/motion.hpp"

namespace torquewright::hopper {

/// How far the robot may be at one take-off from what it was at the one before, in m or rad and in
/// m/s or rad/s: what is left of it at every seam is an error that a controller has to mend.
inline constexpr double kAlike = 2e-3;
inline constexpr double kAlikeRate = 0.02;

/// Returns a motion of so many flights: what lies between its last two take-offs follows itself as
/// often as that takes, each time as much later and farther on. Throws io::SpecError where the
/// motion has fewer than two take-offs or as many flights already, does not say what touches (its
/// contact flags do), goes over ground that is not flat, or where the robot is not alike at both
/// take-offs up to where it is: with what differs most.
Motion with_flights(const Robot& robot, Motion motion, int flights);

}  // namespace torquewright::hopper
