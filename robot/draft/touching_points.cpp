// SPDX-License-Identifier: Apache-2.0
#include "robot/draft/touching_points.hpp"

#include <cmath>
#include <numbers>

namespace torquewright::hopper {
namespace {

using Eigen::Vector3d;

/// At both ends of the shape's z.
std::vector<TouchingPoint> end_balls(const DraftShape& shape) {
  const Vector3d half_m = shape.R.col(2) * shape.size_m[1];
  return {{shape.p_m + half_m, shape.size_m[0]}, {shape.p_m - half_m, shape.size_m[0]}};
}

/// The corners of the side of the box that looks down most.
std::vector<TouchingPoint> lower_corners(const DraftShape& shape, const Vector3d& down) {
  const Vector3d seen = shape.R.transpose() * down;
  Eigen::Index side = 0;
  seen.cwiseAbs().maxCoeff(&side);
  std::vector<TouchingPoint> points;
  for (const auto& [one, other] : {std::pair{1.0, 1.0}, {1.0, -1.0}, {-1.0, -1.0}, {-1.0, 1.0}}) {
    Vector3d corner_m;
    corner_m[side] = std::copysign(shape.size_m[side], seen[side]);
    corner_m[(side + 1) % 3] = one * shape.size_m[(side + 1) % 3];
    corner_m[(side + 2) % 3] = other * shape.size_m[(side + 2) % 3];
    points.push_back({shape.p_m + shape.R * corner_m, 0});
  }
  return points;
}

std::vector<TouchingPoint> of_cylinder(const DraftShape& shape, const Vector3d& down) {
  const double along = shape.R.col(2).dot(down);
  if (std::abs(along) < std::numbers::sqrt2 / 2) return end_balls(shape);
  const double radius_m = shape.size_m[0];
  const double end_m = std::copysign(shape.size_m[1], along);
  std::vector<TouchingPoint> points;
  for (const Vector3d& rim_m : {Vector3d(radius_m, 0, end_m), Vector3d(0, radius_m, end_m),
                                Vector3d(-radius_m, 0, end_m), Vector3d(0, -radius_m, end_m)}) {
    points.push_back({shape.p_m + shape.R * rim_m, 0});
  }
  return points;
}

}  // namespace

std::vector<TouchingPoint> touching_points(const DraftShape& shape, const Vector3d& down) {
  switch (shape.primitive) {
    case Primitive::kSphere:
      return {{shape.p_m, shape.size_m[0]}};
    case Primitive::kCapsule:
      return end_balls(shape);
    case Primitive::kCylinder:
      return of_cylinder(shape, down);
    case Primitive::kBox:
      return lower_corners(shape, down);
    case Primitive::kEllipsoid:
      return {};
  }
  return {};
}

}  // namespace torquewright::hopper
