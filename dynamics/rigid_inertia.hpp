// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/tree.hpp"

namespace torquewright::dynamics {

/// The same body seen from frame A, in which its own frame B stands as R_AB and p_AB_m say.
RigidInertia moved(const RigidInertia& inertia, const Eigen::Matrix3d& R_AB,
                   const Eigen::Vector3d& p_AB_m);

/// Two bodies of one frame, welded; parallel axes (Steiner).
RigidInertia welded(const RigidInertia& one, const RigidInertia& other);

}  // namespace torquewright::dynamics
