// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identification/robot_plan/commanded_motion.hpp"
#include "identification/rollout/free_values.hpp"

namespace torquewright::identification {

/// What one run's positions say of a limb's values, (values x values), in their sizes: slopes of
/// the positions simulated under the joints' own loops, by differences, over the noise. Empty where
/// a simulation grows without bound.
Eigen::MatrixXd information_of(const RobotModel& model, std::size_t limb,
                               const std::vector<FreeValue>& values, const CommandedMotion& motion,
                               double noise_rad);

/// What was known of the values before, in their sizes: a diagonal.
Eigen::VectorXd known_before(const std::vector<FreeValue>& values);

}  // namespace torquewright::identification
