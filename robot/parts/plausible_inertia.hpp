// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

namespace torquewright::hopper {

/// Why no rigid body has this inertia about its centre of mass, in a sentence; none if one may
/// have: principal moments are positive and each is at most the sum of the others (but for
/// rounding).
std::optional<std::string> inertia_objection(const Eigen::Matrix3d& inertia_kg_m2);

}  // namespace torquewright::hopper
