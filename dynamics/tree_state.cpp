// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/rigid_body.md.
#include "dynamics/tree_state.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace torquewright::dynamics {
namespace {

/// R times the rotation about a unit axis; eq. (1).
Eigen::Matrix3d turned(const Eigen::Matrix3d& R, const Eigen::Vector3d& axis, double angle_rad) {
  return R * Eigen::AngleAxisd(angle_rad, axis).toRotationMatrix();
}

Eigen::Quaterniond unit_quaternion(const Eigen::Vector4d& wxyz) {
  const double norm = wxyz.norm();
  if (!(norm > 0)) throw std::invalid_argument("tree state: the base's quaternion is zero");
  return {wxyz[0] / norm, wxyz[1] / norm, wxyz[2] / norm, wxyz[3] / norm};
}

}  // namespace

Eigen::VectorXd zero_position(const Tree& tree) {
  Eigen::VectorXd position = Eigen::VectorXd::Zero(tree.position_size());
  if (tree.base == BaseKind::kSpatial) position[3] = 1;
  return position;
}

void require_velocity_size(const TreeState& state, Eigen::Index size) {
  if (size != state.velocity().size()) {
    throw std::invalid_argument("tree state: one element per velocity");
  }
}

TreeState::TreeState(Tree tree) : tree_(std::move(tree)) {
  require_tree(tree_);
  base_size_ = tree_.base_velocity_size();
  const Eigen::Index size = tree_.velocity_size();
  velocity_.resize(size);
  motions_.resize(tree_.bodies.size());
  newton_.resize(tree_.bodies.size());
  composites_.resize(tree_.bodies.size());
  vector_scratch_.resize(size);
  solution_scratch_.resize(size);
  matrix_scratch_.resize(size, size);
  set(zero_position(tree_), Eigen::VectorXd::Zero(size));
}

void TreeState::set(const VectorIn& position, const VectorIn& velocity) {
  if (position.size() != tree_.position_size() || velocity.size() != velocity_.size()) {
    throw std::invalid_argument("tree state: wrong number of positions or velocities");
  }
  if (!position.allFinite() || !velocity.allFinite()) {
    throw std::invalid_argument("tree state: a position or velocity is not finite");
  }
  velocity_ = velocity;
  place_base(position);
  const Eigen::Index extra = position.size() - velocity.size();
  for (std::size_t i = 1; i < motions_.size(); ++i) place_body(i, position[joint_row(i) + extra]);
}

void TreeState::place_base(const VectorIn& position) {
  const Body& body = tree_.bodies.front();
  BodyMotion& base = motions_.front();
  base.origin_m.setZero();
  base.from_parent_m.setZero();
  base.axis.setZero();
  base.angular_velocity_rad_s.setZero();
  base.velocity_m_s.setZero();
  switch (tree_.base) {
    case BaseKind::kFixed:
      base_origin_m_ = body.joint.p_PB_m;
      base.R_WB = body.joint.R_PB;
      break;
    case BaseKind::kPlanar:
      base_origin_m_ = {position[0], 0, position[1]};
      base.R_WB = turned(Eigen::Matrix3d::Identity(), Eigen::Vector3d::UnitY(), position[2]);
      base.velocity_m_s = {velocity_[0], 0, velocity_[1]};
      base.angular_velocity_rad_s = {0, velocity_[2], 0};
      break;
    case BaseKind::kSpatial:
      base_origin_m_ = position.head<3>();
      base.R_WB = unit_quaternion(position.segment<4>(3)).toRotationMatrix();
      base.velocity_m_s = velocity_.head<3>();
      base.angular_velocity_rad_s = base.R_WB * velocity_.segment<3>(3);
      break;
  }
  base.center_of_mass_m = base.R_WB * body.inertia.center_of_mass_m;
}

// eqs. (1)-(3)
void TreeState::place_body(std::size_t index, double position) {
  const Body& body = tree_.bodies[index];
  const Joint& joint = body.joint;
  const BodyMotion& parent = motions_[body.parent];
  BodyMotion& motion = motions_[index];
  const double rate = joint_velocity(index);
  const Eigen::Matrix3d R_WJ = parent.R_WB * joint.R_PB;  // before the joint turns it
  motion.axis = R_WJ * joint.axis;
  motion.from_parent_m = parent.R_WB * joint.p_PB_m;
  motion.angular_velocity_rad_s = parent.angular_velocity_rad_s;
  motion.velocity_m_s = parent.velocity_m_s;
  if (joint.kind == JointKind::kRevolute) {
    motion.R_WB = turned(R_WJ, joint.axis, position);
    motion.angular_velocity_rad_s += rate * motion.axis;
  } else {
    motion.R_WB = R_WJ;
    motion.from_parent_m += position * motion.axis;
    motion.velocity_m_s += rate * motion.axis;
  }
  motion.velocity_m_s += parent.angular_velocity_rad_s.cross(motion.from_parent_m);
  motion.origin_m = parent.origin_m + motion.from_parent_m;
  motion.center_of_mass_m = motion.origin_m + motion.R_WB * body.inertia.center_of_mass_m;
}

}  // namespace torquewright::dynamics
