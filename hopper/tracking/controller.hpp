// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string_view>

#include "hopper/tracking/control_account.hpp"
#include "hopper/tracking/impact_handling.hpp"
#include "hopper/tracking/reference.hpp"

namespace torquewright::hopper {

/// What a controller sees of the robot, at the moment that latency allows.
struct Observation {
  double time_s = 0.0;     ///< On the reference's clock, when it was so.
  double latency_s = 0.0;  ///< So much later what is asked for begins to act,
  double hold_s = 0.0;     ///< and it acts so long.
  Eigen::VectorXd position;
  Eigen::VectorXd velocity;
  TouchingPoints touches;  ///< Points that the ground pressed on since the last look.
  /// Of the drives, as they were last (drives x 1); empty where nothing was measured yet.
  Eigen::VectorXd bus_V = {};
  Eigen::VectorXd winding_K = {};
};

/// A controller of a robot's drives: a tracking law, later a learned policy. It may remember; one
/// object serves one robot at a time.
class Controller {
 public:
  virtual ~Controller() = default;
  /// Returns its name in options.
  virtual std::string_view name() const = 0;
  /// Begins anew: forgets whatever it remembers of earlier runs.
  virtual void start() = 0;
  /// Torques wanted at the drives' outputs (drives x 1), in Nm, whatever their regions allow. All
  /// finite where the observation is.
  virtual void control(const Observation& seen, Eigen::VectorXd& torque_Nm) = 0;
  /// The part of the torques last wanted that does not depend on what was seen (drives x 1): the
  /// rest is feedback. Zero where there is no such part.
  virtual const Eigen::VectorXd& fed_forward_Nm() const = 0;
  /// What became of its tasks since the start; empty of one that has none.
  virtual ControlAccount account() const { return {}; }
};

}  // namespace torquewright::hopper
