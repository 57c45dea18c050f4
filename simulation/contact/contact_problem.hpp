// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace torquewright::simulation {

/// All points that touch the ground at one instant. Their velocities (3 k x 1; tangent, tangent,
/// normal of each) depend on their impulses (3 k x 1) as u = free + response * impulse.
struct ContactProblem {
  Eigen::MatrixXd response_1_kg;  ///< (3 k x 3 k), symmetric, positive semidefinite.
  Eigen::VectorXd free_m_s;
  Eigen::VectorXd friction_coefficients;  ///< (k x 1)
};

}  // namespace torquewright::simulation
