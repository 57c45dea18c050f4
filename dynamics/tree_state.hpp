// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <type_traits>
#include <vector>

#include "dynamics/tree.hpp"

namespace torquewright::dynamics {

// n velocities: those of the base (0, 3 or 6), then one per joint; positions of a spatial base are
// one more (its quaternion). Tree::velocity_size(), Tree::position_size().
using VectorIn = Eigen::Ref<const Eigen::VectorXd>;
using VectorOut = Eigen::Ref<Eigen::VectorXd>;
using MatrixOut = Eigen::Ref<Eigen::MatrixXd>;
/// A (3 x n) matrix: a row per direction of space, a column per velocity.
using Jacobian = Eigen::Ref<Eigen::Matrix<double, 3, Eigen::Dynamic>>;

// The same on any scalar: double, or numbers that carry derivatives (jet.hpp), for which all of
// dynamics/ is instantiated. Functions take T from the state alone, so that arguments may be
// expressions.
template <typename T>
using VectorX = Eigen::Matrix<T, Eigen::Dynamic, 1>;
template <typename T>
using Vector3 = Eigen::Matrix<T, 3, 1>;
template <typename T>
using Matrix3 = Eigen::Matrix<T, 3, 3>;
template <typename T>
using VectorInOf = std::type_identity_t<Eigen::Ref<const VectorX<T>>>;
template <typename T>
using VectorOutOf = std::type_identity_t<Eigen::Ref<VectorX<T>>>;
template <typename T>
using MatrixOutOf =
    std::type_identity_t<Eigen::Ref<Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>>>;
template <typename T>
using JacobianOf = std::type_identity_t<Eigen::Ref<Eigen::Matrix<T, 3, Eigen::Dynamic>>>;
template <typename T>
using Vector3In = std::type_identity_t<Vector3<T>>;

/// Pose and motion of a body, in the world's axes; positions are relative to the base's origin, so
/// that a robot far from the world's origin loses no digits (docs/derivations/rigid_body.md eqs.
/// (1)-(3)).
template <typename T>
struct BodyMotionOf {
  Matrix3<T> R_WB;
  Vector3<T> origin_m;       ///< Origin of the body's frame, which is at its joint.
  Vector3<T> from_parent_m;  ///< From the parent's origin to this one.
  Vector3<T> axis;           ///< Axis of the joint.
  Vector3<T> center_of_mass_m;
  Vector3<T> angular_velocity_rad_s;
  Vector3<T> velocity_m_s;  ///< Velocity of the body's origin.
};
using BodyMotion = BodyMotionOf<double>;

/// A tree at one position and velocity, with memory to work in. All computations of the dynamics
/// are functions of it (inverse_dynamics.hpp, mass_matrix.hpp, momentum.hpp, ...); none allocates,
/// and one state serves one thread.
template <typename T>
class TreeStateOf {
 public:
  /// Starts at position zero (upright base), at rest. std::invalid_argument: require_tree().
  explicit TreeStateOf(Tree tree);

  /// Sets position and velocity. A quaternion is normalised. std::invalid_argument where sizes are
  /// wrong, a number is not finite, or the quaternion is zero.
  void set(const VectorInOf<T>& position, const VectorInOf<T>& velocity);

  const Tree& tree() const { return tree_; }
  const VectorX<T>& velocity() const { return velocity_; }
  const Vector3<T>& base_origin_m() const { return base_origin_m_; }
  const BodyMotionOf<T>& motion(std::size_t body) const { return motions_[body]; }
  /// Row of a body's joint in vectors of velocities; not for the base.
  Eigen::Index joint_row(std::size_t body) const {
    return base_size_ + static_cast<Eigen::Index>(body) - 1;
  }
  const T& joint_position(std::size_t body) const { return joint_positions_[body]; }
  const T& joint_velocity(std::size_t body) const { return velocity_[joint_row(body)]; }

  /// Memory of inverse_dynamics(): a body's acceleration, and the load of its joint.
  struct Newton {
    Vector3<T> angular_rad_s2;
    Vector3<T> linear_m_s2;  ///< Acceleration of the body's origin.
    Vector3<T> moment_Nm;    ///< Moment about the body's origin.
    Vector3<T> force_N;
  };
  /// Memory of mass_matrix() and of momenta: a body with all that hangs on it, as one rigid body.
  struct Composite {
    double mass_kg;
    Vector3<T> first_moment_kg_m;  ///< First moment about the base's origin, as the inertia.
    Matrix3<T> inertia_kg_m2;
  };
  std::vector<Newton>& newton() { return newton_; }
  std::vector<Composite>& composites() { return composites_; }
  VectorX<T>& vector_scratch() { return vector_scratch_; }
  VectorX<T>& solution_scratch() { return solution_scratch_; }
  Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>& matrix_scratch() { return matrix_scratch_; }

 private:
  void place_base(const VectorInOf<T>& position);
  void place_body(std::size_t body, const T& position);

  Tree tree_;
  Eigen::Index base_size_;
  VectorX<T> velocity_;
  std::vector<T> joint_positions_;  ///< By body; the base's is not used.
  Vector3<T> base_origin_m_ = Vector3<T>::Zero();
  std::vector<BodyMotionOf<T>> motions_;
  std::vector<Newton> newton_;
  std::vector<Composite> composites_;
  VectorX<T> vector_scratch_;
  VectorX<T> solution_scratch_;
  Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> matrix_scratch_;
};
using TreeState = TreeStateOf<double>;

/// Returns position zero, with the quaternion of no rotation: (position_size x 1).
Eigen::VectorXd zero_position(const Tree& tree);

/// Throws std::invalid_argument where the vector does not have one element per velocity.
template <typename T>
void require_velocity_size(const TreeStateOf<T>& state, Eigen::Index size);

}  // namespace torquewright::dynamics
