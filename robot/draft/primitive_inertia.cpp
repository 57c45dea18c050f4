// SPDX-License-Identifier: Apache-2.0
#include "robot/draft/primitive_inertia.hpp"

#include <numbers>

namespace torquewright::hopper {
namespace {

constexpr double kPi = std::numbers::pi;

/// A cylinder, and two half balls whose centres of mass lie 3/8 r outside its ends.
Eigen::Vector3d capsule_m2(double radius_m, double half_m) {
  const double ball_share = 4 * radius_m / (4 * radius_m + 6 * half_m);
  const double rod_share = 1 - ball_share;
  const double r2 = radius_m * radius_m;
  const double h2 = half_m * half_m;
  const double across =
      rod_share * (r2 / 4 + h2 / 3) + ball_share * (2 * r2 / 5 + h2 + 3 * radius_m * half_m / 4);
  const double along = rod_share * r2 / 2 + ball_share * 2 * r2 / 5;
  return {across, across, along};
}

}  // namespace

double volume_m3(Primitive primitive, const PrimitiveSize& size_m) {
  const double r = size_m[0];
  switch (primitive) {
    case Primitive::kSphere:
      return 4 * kPi / 3 * r * r * r;
    case Primitive::kCapsule:
      return kPi * r * r * (4 * r / 3 + 2 * size_m[1]);
    case Primitive::kCylinder:
      return kPi * r * r * 2 * size_m[1];
    case Primitive::kBox:
      return 8 * size_m.prod();
    case Primitive::kEllipsoid:
      return 4 * kPi / 3 * size_m.prod();
  }
  return 0;
}

Eigen::Vector3d moments_per_mass_m2(Primitive primitive, const PrimitiveSize& size_m) {
  const Eigen::Vector3d squares = size_m.cwiseProduct(size_m);
  const Eigen::Vector3d others = Eigen::Vector3d::Constant(squares.sum()) - squares;
  switch (primitive) {
    case Primitive::kSphere:
      return Eigen::Vector3d::Constant(2 * squares[0] / 5);
    case Primitive::kCapsule:
      return capsule_m2(size_m[0], size_m[1]);
    case Primitive::kCylinder: {
      const double across = squares[0] / 4 + squares[1] / 3;
      return {across, across, squares[0] / 2};
    }
    case Primitive::kBox:
      return others / 3;
    case Primitive::kEllipsoid:
      return others / 5;
  }
  return Eigen::Vector3d::Zero();
}

}  // namespace torquewright::hopper
