// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/rigid_body.md.
#include "dynamics/tree_state.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "dynamics/jet_functions.hpp"

namespace torquewright::dynamics {
namespace {

/// R times the rotation about a unit axis; eq. (1).
template <typename T>
Matrix3<T> turned(const Matrix3<T>& R, const Eigen::Vector3d& axis, const T& angle_rad) {
  return R * Eigen::AngleAxis<T>(angle_rad, axis).toRotationMatrix();
}

template <typename T>
Eigen::Quaternion<T> unit_quaternion(const Eigen::Matrix<T, 4, 1>& wxyz) {
  const T norm = wxyz.norm();
  if (!(norm > 0)) throw std::invalid_argument("tree state: the base's quaternion is zero");
  return {wxyz[0] / norm, wxyz[1] / norm, wxyz[2] / norm, wxyz[3] / norm};
}

bool is_finite(const VectorIn& vector) { return vector.allFinite(); }

template <int kOrder>
bool is_finite(const Eigen::Ref<const VectorX<ForwardNumber<kOrder>>>& vector) {
  for (const ForwardNumber<kOrder>& element : vector) {
    if (!isfinite(element)) return false;
  }
  return true;
}

}  // namespace

Eigen::VectorXd zero_position(const Tree& tree) {
  Eigen::VectorXd position = Eigen::VectorXd::Zero(tree.position_size());
  if (tree.base == BaseKind::kSpatial) position[3] = 1;
  return position;
}

template <typename T>
void require_velocity_size(const TreeStateOf<T>& state, Eigen::Index size) {
  if (size != state.velocity().size()) {
    throw std::invalid_argument("tree state: one element per velocity");
  }
}

template <typename T>
TreeStateOf<T>::TreeStateOf(Tree tree) : tree_(std::move(tree)) {
  require_tree(tree_);
  base_size_ = tree_.base_velocity_size();
  const Eigen::Index size = tree_.velocity_size();
  velocity_.resize(size);
  motions_.resize(tree_.bodies.size());
  newton_.resize(tree_.bodies.size());
  composites_.resize(tree_.bodies.size());
  joint_positions_.resize(tree_.bodies.size());
  vector_scratch_.resize(size);
  solution_scratch_.resize(size);
  matrix_scratch_.resize(size, size);
  set(zero_position(tree_).cast<T>(), VectorX<T>::Zero(size));
}

template <typename T>
void TreeStateOf<T>::set(const VectorInOf<T>& position, const VectorInOf<T>& velocity) {
  if (position.size() != tree_.position_size() || velocity.size() != velocity_.size()) {
    throw std::invalid_argument("tree state: wrong number of positions or velocities");
  }
  if (!is_finite(position) || !is_finite(velocity)) {
    throw std::invalid_argument("tree state: a position or velocity is not finite");
  }
  velocity_ = velocity;
  place_base(position);
  const Eigen::Index extra = position.size() - velocity.size();
  for (std::size_t i = 1; i < motions_.size(); ++i) place_body(i, position[joint_row(i) + extra]);
}

template <typename T>
void TreeStateOf<T>::place_base(const VectorInOf<T>& position) {
  const Body& body = tree_.bodies.front();
  BodyMotionOf<T>& base = motions_.front();
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
      base.R_WB = turned<T>(Matrix3<T>::Identity(), Eigen::Vector3d::UnitY(), position[2]);
      base.velocity_m_s = {velocity_[0], 0, velocity_[1]};
      base.angular_velocity_rad_s = {0, velocity_[2], 0};
      break;
    case BaseKind::kSpatial:
      base_origin_m_ = position.template head<3>();
      base.R_WB = unit_quaternion<T>(position.template segment<4>(3)).toRotationMatrix();
      base.velocity_m_s = velocity_.template head<3>();
      base.angular_velocity_rad_s = base.R_WB * velocity_.template segment<3>(3);
      break;
  }
  base.center_of_mass_m = base.R_WB * body.inertia.center_of_mass_m;
}

// eqs. (1)-(3)
template <typename T>
void TreeStateOf<T>::place_body(std::size_t index, const T& position) {
  const Body& body = tree_.bodies[index];
  const Joint& joint = body.joint;
  const BodyMotionOf<T>& parent = motions_[body.parent];
  BodyMotionOf<T>& motion = motions_[index];
  const T& rate = joint_velocity(index);
  joint_positions_[index] = position;
  const Matrix3<T> R_WJ = parent.R_WB * joint.R_PB;  // before the joint turns it
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

template class TreeStateOf<double>;
template class TreeStateOf<Jet>;
template class TreeStateOf<Jet2>;
template void require_velocity_size(const TreeState&, Eigen::Index);
template void require_velocity_size(const TreeStateOf<Jet>&, Eigen::Index);
template void require_velocity_size(const TreeStateOf<Jet2>&, Eigen::Index);

}  // namespace torquewright::dynamics
