// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/tree.hpp"

namespace torquewright::dynamics {

/// Returns the inertia of the same body in frame A, in which its own frame B stands as R_AB and
/// p_AB_m say.
RigidInertia moved(const RigidInertia& inertia, const Eigen::Matrix3d& R_AB,
                   const Eigen::Vector3d& p_AB_m);

/// Returns the inertia of two bodies of one frame, welded, by the parallel axis theorem (Steiner).
RigidInertia welded(const RigidInertia& one, const RigidInertia& other);

}  // namespace torquewright::dynamics
