// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identification/log/log.hpp"
#include "identification/rollout/free_values.hpp"
#include "identification/rollout/windows.hpp"

namespace torquewright::identification {

/// Windows of the runs that are not held out, or of those that are, spread so that they last
/// `most_s` together at most.
std::vector<Window> fit_windows(const Log& log, double most_s, bool held_out = false);

/// Simulated less measured positions of one limb, in rad: window after window, in each its joints
/// one after the other. Empty where a simulation grows without bound.
Eigen::VectorXd output_errors_rad(const Log& log, const RobotModel& model, const Limb& limb,
                                  const std::vector<Window>& windows);

/// How the errors of limb `limb` change with a value, per its size, by a difference; empty where
/// that simulation grows without bound. `errors`: those of the model as it is.
Eigen::VectorXd slope_of(const Log& log, const RobotModel& model, const FreeValue& which,
                         std::size_t limb, const std::vector<Window>& windows,
                         const Eigen::VectorXd& errors);

/// The slopes of several values, a column each; empty where one of those simulations grows without
/// bound.
Eigen::MatrixXd slopes_of(const Log& log, const RobotModel& model,
                          const std::vector<FreeValue>& values, std::size_t limb,
                          const std::vector<Window>& windows, const Eigen::VectorXd& errors);

/// What the squares of errors are worth: 1 for each independent error of their own mean size.
/// `errors`: of the limbs, in the order of `limbs`; samples over which an error stays alike count
/// as one.
double weight_of(const std::vector<Eigen::VectorXd>& errors, const std::vector<Limb>& limbs,
                 const std::vector<Window>& windows);

}  // namespace torquewright::identification
