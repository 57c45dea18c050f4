// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "robot/draft/draft.hpp"

namespace torquewright::hopper {

struct TouchingPoint {
  Eigen::Vector3d p_m;  ///< In the body's frame.
  double radius_m = 0;  ///< Of a ball about it.
};

/// Where a shape meets the ground: a ball; two balls at the ends of a capsule, or of a cylinder
/// that lies; else four points of a box's or cylinder's side that looks along `down`. Nothing of an
/// ellipsoid. `down`: a unit vector in the body's frame.
std::vector<TouchingPoint> touching_points(const DraftShape& shape, const Eigen::Vector3d& down);

}  // namespace torquewright::hopper
