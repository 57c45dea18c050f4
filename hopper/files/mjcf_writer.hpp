// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/files/urdf_writer.hpp"

namespace torquewright::hopper {

/// For MuJoCo 2.2.2 and later: bodies with their inertia, joints with reflected inertia as
/// armature, motors with the torque limits, contact points as sites.
Exported mjcf_of(const Robot& robot);

}  // namespace torquewright::hopper
