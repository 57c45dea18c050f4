// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "robot/model/whole_body.hpp"

namespace torquewright::hopper {

/// Numbers of the kinds of free rows, in this order.
struct RowKinds {
  Eigen::Index forces = 0;             ///< Rows of forces on the base.
  Eigen::Index moments = 0;            ///< Rows of moments on the base, about the centre of mass.
  Eigen::Index passives = 0;           ///< Rows of joints without an actuator.
  std::vector<Eigen::Index> slides{};  ///< Indices of those rows that hold forces of slides (N).
};

/// The rows of the equations of motion that no actuator appears in: those of a floating base, and
/// of joints that nothing drives. What acts on them must come from the ground. The base's moments
/// are taken about the centre of mass, so that force and moment do not mix.
class FreeRows {
 public:
  explicit FreeRows(const WholeBody& body);

  Eigen::Index size() const { return base_ + static_cast<Eigen::Index>(passive_.size()); }
  Eigen::Index base_size() const { return base_; }

  /// Sets the posture, with its centre of mass [world, from the world's origin].
  void set(const dynamics::TreeState& state, const Eigen::Vector3d& center_of_mass_m);

  /// Selects and rotates the free rows of columns (n x k) that have one row per velocity: (size() x
  /// k).
  void take(const Eigen::Ref<const Eigen::MatrixXd>& from, Eigen::Ref<Eigen::MatrixXd> to) const;

  /// (size() x 1), N and Nm: scales that make the rows comparable, the weight and the weight times
  /// the robot's size.
  Eigen::VectorXd scales(double weight_N, double size_m) const;

  RowKinds kinds() const;

 private:
  dynamics::BaseKind kind_;
  Eigen::Index base_;
  std::vector<Eigen::Index> passive_;  ///< Rows of velocity.
  std::vector<Eigen::Index> slides_;
  Eigen::MatrixXd turn_;  ///< Square matrix that turns the base's rows.
};

}  // namespace torquewright::hopper
