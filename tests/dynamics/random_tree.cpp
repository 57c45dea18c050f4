// SPDX-License-Identifier: Apache-2.0
#include "tests/dynamics/random_tree.hpp"

#include <Eigen/Geometry>

namespace torquewright::test {

using dynamics::BaseKind;
using dynamics::Body;
using dynamics::JointKind;
using dynamics::RigidInertia;
using dynamics::Tree;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using oracles::Dice;

Vector3d random_direction(Dice& dice) {
  for (;;) {
    const Vector3d drawn = uniform_vector(dice, 3, 1);
    if (drawn.norm() > 0.1) return drawn.normalized();
  }
}

Matrix3d random_rotation(Dice& dice) {
  return Eigen::AngleAxisd(uniform(dice, 0, 3), random_direction(dice)).toRotationMatrix();
}

RigidInertia random_inertia(Dice& dice) {
  RigidInertia inertia;
  inertia.mass_kg = uniform(dice, 0.1, 8);
  inertia.center_of_mass_m = uniform_vector(dice, 3, 0.3);
  // Moments of three masses on three axes: x, y, z give y + z, x + z, x + y.
  const Vector3d masses = uniform_vector(dice, 3, 0.1).cwiseAbs() + Vector3d::Constant(0.002);
  const Vector3d moments = Vector3d::Constant(masses.sum()) - masses;
  const Matrix3d R = random_rotation(dice);
  const Matrix3d turned = R * moments.asDiagonal() * R.transpose();
  inertia.inertia_kg_m2 = 0.5 * (turned + turned.transpose());
  return inertia;
}

Tree random_tree(Dice& dice, BaseKind base, std::size_t joints) {
  Tree tree;
  tree.base = base;
  for (std::size_t i = 0; i <= joints; ++i) {
    Body body;
    body.name = "body_" + std::to_string(i);
    body.parent = i == 0 ? 0 : static_cast<std::size_t>(dice.between(0, static_cast<int>(i) - 1));
    body.joint.kind = dice.chance(75) ? JointKind::kRevolute : JointKind::kPrismatic;
    body.joint.R_PB = random_rotation(dice);
    body.joint.p_PB_m = uniform_vector(dice, 3, 0.6);
    body.joint.axis = random_direction(dice);
    if (i > 0 && dice.chance(50)) body.joint.reflected_inertia = uniform(dice, 0, 0.5);
    body.inertia = random_inertia(dice);
    tree.bodies.push_back(body);
  }
  return tree;
}

Eigen::VectorXd random_position(Dice& dice, const Tree& tree) {
  Eigen::VectorXd position = uniform_vector(dice, tree.position_size(), 4);
  if (tree.base == BaseKind::kSpatial) position[3] += 0.01;  // never the zero quaternion
  return position;
}

}  // namespace torquewright::test
