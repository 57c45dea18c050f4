// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace torquewright::test {

/// One contact by itself, in axes (tangent, tangent, normal).
struct LocalContact {
  Eigen::Matrix3d mobility;  ///< Velocity per impulse on the point; positive definite. 1/kg.
  Eigen::Vector3d velocity;  ///< After the impact without this contact's impulse, m/s. Its normal
                             ///< part counts from the speed that restitution asks for.
  double friction_coefficient = 0;
};

/// The impulse that parts, sticks or slides, by docs/derivations/impact.md eqs. (4)-(6).
Eigen::Vector3d impulse_N_s(const LocalContact& contact);

}  // namespace torquewright::test
