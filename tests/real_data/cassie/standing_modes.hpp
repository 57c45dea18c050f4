// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "hopper/tracking/controller.hpp"

namespace torquewright::test {

/// How small deviations of a robot go on that stands under a controller while its feet hold to the
/// ground: exp(s t) for each s, in 1/s, the fastest growing one first.
struct StandingModes {
  Eigen::VectorXcd rates_1_s;
  Eigen::MatrixXcd shapes;  ///< (2 n x modes): deviations of positions, then of velocities.
};

/// How a controller answers: torques as a lag lets them, half the time for which they are held; and
/// of what its first look sees of velocities it later sees what a low-pass lets pass (0: nothing).
struct AnswerTimes {
  double lag_s = 0.0;
  double low_pass_s = 0.0;
};

/// The modes about a reference's posture at rest, by central differences of the controller's
/// torques and of the accelerations that they make. Directions in which a held foot would move are
/// left out.
StandingModes standing_modes(const hopper::Robot& robot, const hopper::ReferenceInstant& stands,
                             hopper::Controller& controller, const AnswerTimes& times);

}  // namespace torquewright::test
