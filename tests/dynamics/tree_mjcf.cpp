// SPDX-License-Identifier: Apache-2.0
#include "tests/dynamics/tree_mjcf.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace torquewright::test {
namespace {

using dynamics::BaseKind;
using dynamics::Body;
using dynamics::JointKind;
using dynamics::Tree;

std::string text(const Eigen::Vector3d& v) { return fmt::format("{} {} {}", v[0], v[1], v[2]); }

std::string quaternion_text(const Eigen::Matrix3d& R) {
  const Eigen::Quaterniond q(R);
  return fmt::format("{} {} {} {}", q.w(), q.x(), q.y(), q.z());
}

/// Principal moments and axes: MuJoCo's own diagonalisation is good to twelve digits only.
std::string inertial(const dynamics::RigidInertia& inertia) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(inertia.inertia_kg_m2);
  Eigen::Matrix3d R = axes.eigenvectors();
  if (R.determinant() < 0) R.col(0) *= -1;
  return fmt::format(R"(<inertial pos="{}" mass="{}" quat="{}" diaginertia="{}"/>)",
                     text(inertia.center_of_mass_m), inertia.mass_kg, quaternion_text(R),
                     text(axes.eigenvalues()));
}

std::string joints_of(const Tree& tree, std::size_t index) {
  const dynamics::Joint& joint = tree.bodies[index].joint;
  if (index > 0) {
    return fmt::format(R"(<joint type="{}" axis="{}" armature="{}"/>)",
                       joint.kind == JointKind::kRevolute ? "hinge" : "slide", text(joint.axis),
                       joint.reflected_inertia);
  }
  if (tree.base == BaseKind::kFixed) return "";
  if (tree.base == BaseKind::kSpatial) return "<freejoint/>";
  return R"(<joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 0 1"/>)"
         R"(<joint type="hinge" axis="0 1 0"/>)";
}

std::string body_text(const Tree& tree, std::size_t index) {
  const Body& body = tree.bodies[index];
  const bool placed = index > 0 || tree.base == BaseKind::kFixed;
  std::string result =
      fmt::format(R"(<body name="{}" pos="{}" quat="{}">)", body.name,
                  text(placed ? body.joint.p_PB_m : Eigen::Vector3d(Eigen::Vector3d::Zero())),
                  placed ? quaternion_text(body.joint.R_PB) : "1 0 0 0");
  result += joints_of(tree, index) + inertial(body.inertia);
  for (std::size_t i = index + 1; i < tree.bodies.size(); ++i) {
    if (tree.bodies[i].parent == index) result += body_text(tree, i);
  }
  return result + "</body>\n";
}

void number(const Tree& tree, std::size_t index, std::vector<Eigen::Index>& rows) {
  if (index > 0) {
    rows.push_back(tree.base_velocity_size() + static_cast<Eigen::Index>(index) - 1);
  }
  for (std::size_t i = index + 1; i < tree.bodies.size(); ++i) {
    if (tree.bodies[i].parent == index) number(tree, i, rows);
  }
}

}  // namespace

std::string mjcf_of(const Tree& tree) {
  return fmt::format(
      "<mujoco><compiler angle=\"radian\"/><option gravity=\"0 0 {}\"/>"
      "<worldbody>\n{}</worldbody></mujoco>",
      -tree.gravity_m_s2, body_text(tree, 0));
}

std::vector<Eigen::Index> rows_of_mujoco(const Tree& tree) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index k = 0; k < tree.base_velocity_size(); ++k) rows.push_back(k);
  number(tree, 0, rows);
  return rows;
}

}  // namespace torquewright::test
