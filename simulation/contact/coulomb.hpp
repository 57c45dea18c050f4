// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace torquewright::simulation {

/// One point on the ground, and how its velocity depends on an impulse on it (tangent, tangent,
/// normal; N s): u = free + response * impulse, with axes as in the impulse.
struct PointResponse {
  Eigen::Matrix3d response_1_kg;  ///< Symmetric, positive semidefinite; a row of zeros: that
                                  ///< direction cannot move, as y in a planar tree.
  Eigen::Vector3d free_m_s;
  double friction_coefficient = 0.0;
};

/// Returns the impulse of unilateral contact with Coulomb's friction: 0 <= u_n, 0 <= p_n, u_n p_n =
/// 0, |p_t| <= mu p_n, and p_t opposes u_t with all of mu p_n where the point slides
/// (docs/derivations/time_stepping.md eqs. (4)-(6)). There always is one; where there are several
/// (Painleve), open contact is preferred to sticking, sticking to sliding. Requires a positive
/// normal response.
Eigen::Vector3d coulomb_impulse_N_s(const PointResponse& point);

}  // namespace torquewright::simulation
