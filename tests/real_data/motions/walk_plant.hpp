// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "robot/model/robot.hpp"
#include "simulation/contact/time_stepping.hpp"

namespace torquewright::test {

struct WalkState {
  Eigen::VectorXd position, velocity;  ///< (7 x 1)
};

/// Rabbit on the ground.
class WalkPlant {
 public:
  virtual ~WalkPlant() = default;
  /// A step with the joints' torques (4 x 1). From `lands` on, the swinging foot may land; what
  /// part of the step had gone by when it did, or -1.
  virtual std::optional<double> step(WalkState& state, const Eigen::VectorXd& torque_Nm,
                                     double step_s, bool may_land) = 0;
};

/// One foot is held where it stands, whatever force that takes; when the other reaches the ground
/// it stops there at once (rigid, plastic, without slip), and from then on it is the one that is
/// held. Runge and Kutta's fourth order.
std::unique_ptr<WalkPlant> held_plant(const hopper::Robot& robot, std::size_t stance,
                                      double landing_height_m);

/// Both feet press and slide as the ground lets them (simulation::TimeStepping, flat ground, the
/// robot's friction coefficients).
std::unique_ptr<WalkPlant> stepping_plant(const hopper::Robot& robot, std::size_t stance);

}  // namespace torquewright::test
