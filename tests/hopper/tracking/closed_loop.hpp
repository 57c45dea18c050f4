// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "hopper/engines/engine.hpp"
#include "hopper/tracking/controller.hpp"
#include "robot/model/whole_body.hpp"

namespace torquewright::hopper::test {

/// Control and simulation keep their own time.
struct Timing {
  double control_s = 5e-4;
  int steps = 5;  ///< Of the simulation in a control period.
};

/// A robot in its own engine under a controller, without motors and latency.
class ClosedLoop {
 public:
  ClosedLoop(const Robot& robot, Controller& controller, Timing timing = {});

  void start(const Eigen::VectorXd& position, const Eigen::VectorXd& velocity, double time_s);
  /// Until then; `look` after every control period. False where a step fails.
  bool run_until(double time_s, const std::function<void()>& look = {});

  double time_s() const { return time_s_; }
  const Eigen::VectorXd& position() const { return engine_->position(); }
  const Eigen::VectorXd& velocity() const { return engine_->velocity(); }
  const TouchingPoints& touches() const { return touches_; }
  const Eigen::VectorXd& torque_Nm() const { return torque_Nm_; }

 private:
  Controller* controller_;
  Timing timing_;
  WholeBody body_;
  std::unique_ptr<Engine> engine_;
  TouchingPoints touches_;
  Eigen::VectorXd torque_Nm_;
  double time_s_ = 0.0;
};

Robot robot_of(const std::string& file);

/// A motion of specs/trajectory with the torques that it asks for, as the check finds them.
struct PlannedMotion {
  PlannedMotion(const std::string& robot_file, const std::string& motion_file);
  Robot robot;
  Motion motion;
  std::unique_ptr<Reference> reference;
};

/// The position lifted or lowered so that its lowest contact is on the ground.
Eigen::VectorXd on_ground(const Robot& robot, Eigen::VectorXd position);

/// A reference that stands still in a posture with the whole foot on the ground, with the torques
/// that this asks for.
Reference standing(const Robot& robot, const Eigen::VectorXd& position, double duration_s);

/// The hopper on its whole foot, knee and ankle bent, its centre of mass above the foot's middle.
Eigen::VectorXd crouch(const Robot& hopper);

}  // namespace torquewright::hopper::test
