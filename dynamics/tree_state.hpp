// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "dynamics/tree.hpp"

namespace torquewright::dynamics {

// n velocities: those of the base (0, 3 or 6), then one per joint; positions of a spatial base are
// one more (its quaternion). Tree::velocity_size(), Tree::position_size().
using VectorIn = Eigen::Ref<const Eigen::VectorXd>;
using VectorOut = Eigen::Ref<Eigen::VectorXd>;
using MatrixOut = Eigen::Ref<Eigen::MatrixXd>;
/// (3 x n): a row per direction of space, a column per velocity.
using Jacobian = Eigen::Ref<Eigen::Matrix<double, 3, Eigen::Dynamic>>;

/// Where a body is and how it moves. All in the world's axes; places are relative to the base's
/// origin, so that a robot far from the world's origin loses no digits.
/// docs/derivations/rigid_body.md eqs. (1)-(3).
struct BodyMotion {
  Eigen::Matrix3d R_WB;
  Eigen::Vector3d origin_m;       ///< Of the body's frame, which is at its joint.
  Eigen::Vector3d from_parent_m;  ///< From the parent's origin to this one.
  Eigen::Vector3d axis;           ///< Of the joint.
  Eigen::Vector3d center_of_mass_m;
  Eigen::Vector3d angular_velocity_rad_s;
  Eigen::Vector3d velocity_m_s;  ///< Of the body's origin.
};

/// A tree at one position and velocity, and room to work in. All questions to the dynamics are
/// functions of it (inverse_dynamics.hpp, mass_matrix.hpp, momentum.hpp, ...); none allocates, and
/// one state serves one thread.
class TreeState {
 public:
  /// At position zero (upright base), at rest. std::invalid_argument: require_tree().
  explicit TreeState(Tree tree);

  /// A quaternion is normalised. std::invalid_argument where sizes are wrong, a number is not
  /// finite, or the quaternion is zero.
  void set(const VectorIn& position, const VectorIn& velocity);

  const Tree& tree() const { return tree_; }
  const Eigen::VectorXd& velocity() const { return velocity_; }
  const Eigen::Vector3d& base_origin_m() const { return base_origin_m_; }
  const BodyMotion& motion(std::size_t body) const { return motions_[body]; }
  /// Row of a body's joint in vectors of velocities; not for the base.
  Eigen::Index joint_row(std::size_t body) const {
    return base_size_ + static_cast<Eigen::Index>(body) - 1;
  }
  double joint_velocity(std::size_t body) const { return velocity_[joint_row(body)]; }

  /// Room of inverse_dynamics(): a body's acceleration, and what its joint must carry.
  struct Newton {
    Eigen::Vector3d angular_rad_s2;
    Eigen::Vector3d linear_m_s2;  ///< Of the body's origin.
    Eigen::Vector3d moment_Nm;    ///< About the body's origin.
    Eigen::Vector3d force_N;
  };
  /// Room of mass_matrix() and of momenta: a body with all that hangs on it, as one rigid body.
  struct Composite {
    double mass_kg;
    Eigen::Vector3d first_moment_kg_m;  ///< About the base's origin, as the inertia.
    Eigen::Matrix3d inertia_kg_m2;
  };
  std::vector<Newton>& newton() { return newton_; }
  std::vector<Composite>& composites() { return composites_; }
  Eigen::VectorXd& vector_scratch() { return vector_scratch_; }
  Eigen::VectorXd& solution_scratch() { return solution_scratch_; }
  Eigen::MatrixXd& matrix_scratch() { return matrix_scratch_; }

 private:
  void place_base(const VectorIn& position);
  void place_body(std::size_t body, double position);

  Tree tree_;
  Eigen::Index base_size_;
  Eigen::VectorXd velocity_;
  Eigen::Vector3d base_origin_m_ = Eigen::Vector3d::Zero();
  std::vector<BodyMotion> motions_;
  std::vector<Newton> newton_;
  std::vector<Composite> composites_;
  Eigen::VectorXd vector_scratch_;
  Eigen::VectorXd solution_scratch_;
  Eigen::MatrixXd matrix_scratch_;
};

/// Position zero, with the quaternion of no rotation: (position_size x 1).
Eigen::VectorXd zero_position(const Tree& tree);

/// std::invalid_argument where the vector does not have one element per velocity.
void require_velocity_size(const TreeState& state, Eigen::Index size);

}  // namespace torquewright::dynamics
