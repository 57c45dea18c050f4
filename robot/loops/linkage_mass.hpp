// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "robot/loops/loop_follower.hpp"
#include "robot/loops/rod_loop.hpp"

namespace torquewright::hopper {

/// Puts what a loop's rod and crank weigh where our mechanisms can hold it: the rod to its two pins
/// as points, so that its centre of mass stays where it is along it; the crank, with its pin's
/// point, to the place of its axis in the ground, as it looks averaged over a turn. Returns the
/// crank's inertia about its axis, which the drive turns.
double lump_links(const RodLoop& loop, const LoopFollower& file_posture,
                  std::vector<DraftBody>& draft);

/// The greatest share of the kinetic energy, over all motions, by which one mass matrix is off
/// another, which is positive definite.
double share_off(const Eigen::MatrixXd& found, const Eigen::MatrixXd& exact);

}  // namespace torquewright::hopper
