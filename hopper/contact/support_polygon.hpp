// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace torquewright::hopper {

/// The convex hull of points in one plane and unit, counter-clockwise, without points on its edges.
/// Fewer than three where they lie on a line. Andrew's monotone chain (1979).
std::vector<Eigen::Vector2d> support_polygon(std::vector<Eigen::Vector2d> points);

/// Distance from a point to the nearest line of a hull's edges, in m; negative outside. Requires
/// three corners.
double distance_inside(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& point);

}  // namespace torquewright::hopper
