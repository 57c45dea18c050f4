// SPDX-License-Identifier: Apache-2.0
#include "src/report/turning/body_shapes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace torquewright::report {
namespace {

using Eigen::Vector3d;

constexpr double kDensity_kg_m3 = 2000.0;
constexpr double kThinnest = 0.08;  // radius over the longest capsule's length

/// Ends of a body's capsules besides its own origin.
std::vector<Vector3d> ends_of(const hopper::Robot& robot, std::size_t body) {
  std::vector<Vector3d> ends;
  for (std::size_t child = 1; child < robot.tree.bodies.size(); ++child) {
    const dynamics::Body& carried = robot.tree.bodies[child];
    if (carried.parent == body) ends.push_back(carried.joint.p_PB_m);
  }
  for (const hopper::ContactPoint& contact : robot.contacts) {
    if (contact.point.body == body) ends.push_back(contact.point.p_B_m);
  }
  for (const hopper::CollisionSphere& sphere : robot.spheres) {
    if (sphere.center.body == body) ends.push_back(sphere.center.p_B_m);
  }
  if (ends.empty()) ends.push_back(robot.tree.bodies[body].inertia.center_of_mass_m);
  return ends;
}

void add_capsules(const hopper::Robot& robot, std::size_t body, BodyShape& shape) {
  double length_m = 0.0;
  double longest_m = 0.0;
  for (const Vector3d& end : ends_of(robot, body)) {
    length_m += end.norm();
    longest_m = std::max(longest_m, end.norm());
    shape.capsules.push_back({Vector3d::Zero(), end, 0.0});
  }
  const double mass_kg = robot.tree.bodies[body].inertia.mass_kg;
  const double radius_m =
      std::max(capsule_radius_m(mass_kg, length_m), kThinnest * 0.5 * longest_m);
  for (DrawnCapsule& capsule : shape.capsules) capsule.radius_m = radius_m;
}

/// Thin: they only tie the joints to the box.
void thin_out(BodyShape& shape) {
  const double least_half_m = shape.box->half_m.minCoeff();
  for (DrawnCapsule& capsule : shape.capsules) {
    capsule.radius_m = std::min(capsule.radius_m, 0.3 * least_half_m);
  }
}

}  // namespace

double capsule_radius_m(double mass_kg, double length_m) {
  if (!(mass_kg > 0.0)) return 0.0;
  // pi r^2 L + 4/3 pi r^3 = m / density rises with r: halving finds it.
  const double volume_m3 = mass_kg / kDensity_kg_m3;
  double low = 0.0;
  double high = std::cbrt(volume_m3);
  for (int i = 0; i < 60; ++i) {
    const double r = 0.5 * (low + high);
    const double is_m3 = std::numbers::pi * r * r * (length_m + 4.0 / 3.0 * r);
    (is_m3 < volume_m3 ? low : high) = r;
  }
  return 0.5 * (low + high);
}

std::optional<DrawnBox> box_of_inertia(const dynamics::RigidInertia& inertia) {
  if (!(inertia.mass_kg > 0.0)) return std::nullopt;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(inertia.inertia_kg_m2);
  const Vector3d& I = principal.eigenvalues();
  // Of a box: I_x = m (b^2 + c^2) / 3 with half lengths a, b, c.
  const Vector3d squares = (Vector3d::Constant(I.sum()) - 2.0 * I) * 1.5 / inertia.mass_kg;
  if (!(squares.minCoeff() > 0.0)) return std::nullopt;
  DrawnBox box{inertia.center_of_mass_m, squares.cwiseSqrt(), principal.eigenvectors()};
  if (box.axes.determinant() < 0.0) box.axes.col(0) *= -1.0;
  return box;
}

std::vector<BodyShape> body_shapes(const hopper::Robot& robot) {
  std::vector<BodyShape> shapes(robot.tree.bodies.size());
  for (std::size_t body = 0; body < shapes.size(); ++body) {
    add_capsules(robot, body, shapes[body]);
  }
  bool base_has_spheres = false;
  for (const hopper::CollisionSphere& sphere : robot.spheres) {
    const Vector3d& at = sphere.center.p_B_m;
    shapes[sphere.center.body].capsules.push_back({at, at, sphere.radius_m});
    base_has_spheres = base_has_spheres || sphere.center.body == 0;
  }
  if (base_has_spheres) return shapes;
  shapes.front().box = box_of_inertia(robot.tree.bodies.front().inertia);
  if (shapes.front().box) thin_out(shapes.front());
  return shapes;
}

}  // namespace torquewright::report
