// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "dynamics/tree.hpp"

namespace torquewright::hopper {

/// How the joints stand at a named moment, over an upright base.
struct Posture {
  std::string name;
  Eigen::VectorXd joints;  ///< Of the body of each joint, base left out; zero where not named.
};

/// The tree's position: base at the origin, upright; joints as in the posture.
Eigen::VectorXd position_of(const dynamics::Tree& tree, const Posture& posture);

/// How a robot stands where nothing else is said: its posture "stand", else "home", as keyframes of
/// MJCF call it, where that is not the one of all joints at zero. Null: neither.
const Posture* standing_posture(const std::vector<Posture>& postures);

/// Inertia of the whole robot as if it were one body, about the pitch axis through its centre of
/// mass: angular momentum about y over the angular velocity about y that goes with it (CAM over
/// CAV). The same for whatever pitch and whatever speeds of the joints. Requires a posture of this
/// tree and bodies with inertia.
double pitch_inertia_kg_m2(const dynamics::Tree& tree, const Posture& posture);

}  // namespace torquewright::hopper
