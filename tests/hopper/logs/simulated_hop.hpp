// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hopper/motion/motion.hpp"
#include "tests/hopper/logs/public_hopper.hpp"

namespace torquewright::test {

/// What MuJoCo computed at every fine step, in our order of coordinates.
struct SimulatedHop {
  double step_s = 0.0;
  hopper::Motion motion;                  ///< With everything given: rates, torques, forces, flags.
  Eigen::MatrixXd angular_momentum_Nm_s;  ///< (3 x samples), about the centre of mass.
};

/// Ground of MuJoCo's default softness, balls of 1 mm at the contact points without a radius;
/// fourth-order Runge-Kutta.
SimulatedHop simulate_hop(const PublicHopper& hopper);

}  // namespace torquewright::test
