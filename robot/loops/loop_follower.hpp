// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "dynamics/tree_state.hpp"
#include "robot/draft/draft.hpp"
#include "robot/loops/rod_loop.hpp"

namespace torquewright::hopper {

/// A file's bodies with cranks and rods as bodies, and their loops closed by numbers: what a
/// linkage read from them is held against. Its base floats, whatever the file's: a base at rest is
/// one of its motions, and gravity is the inertia against a base that accelerates.
class LoopFollower {
 public:
  /// Begins where the file puts the bodies; loops are as open as they are there.
  LoopFollower(const std::vector<DraftBody>& draft, std::vector<RodLoop> loops);

  /// Where a point of another body is in the frame of this one.
  Eigen::Vector3d seen_from(const dynamics::BodyPoint& point, std::size_t body) const;
  /// Axis of the joint that carries a body, in the world's axes.
  const Eigen::Vector3d& axis(std::size_t body) const { return state_.motion(body).axis; }
  double position(std::size_t body) const { return q_[row_of_position(body)]; }

  /// Turns a joint that is no crank's or rod's; loops are then open until close().
  void turn(std::size_t body, double position) { q_[row_of_position(body)] = position; }
  /// Moves cranks and rods as little as it takes, by Newton's method. The greatest gap left, m.
  double close();

  /// (n x n) over the velocities of all joints that are no crank's or rod's, in the order of the
  /// drafts, behind the base's six: what the file's bodies weigh while their loops stay closed.
  Eigen::MatrixXd mass_matrix();

 private:
  Eigen::Index row_of_position(std::size_t body) const {
    return 6 + static_cast<Eigen::Index>(body);  // behind the base's seven
  }
  bool is_link(std::size_t body) const;
  Eigen::VectorXd gaps_m() const;
  Eigen::MatrixXd gap_jacobian() const;
  void set();

  std::vector<RodLoop> loops_;
  std::vector<std::size_t> links_;
  std::vector<Eigen::Index> link_rows_;  ///< In velocities.
  std::vector<Eigen::Index> own_rows_;   ///< Of the base and of all other joints.
  dynamics::TreeState state_;
  Eigen::VectorXd q_;
};

/// The tree of drafts without welds, on a base that floats and weighs so much more, 1 m from its
/// origin on all sides.
dynamics::Tree floating_tree(const std::vector<DraftBody>& draft, double base_kg);
/// A base without mass, the world, is to weigh what all that it carries does; another no more than
/// it does.
double base_kg_of(const std::vector<DraftBody>& draft);

}  // namespace torquewright::hopper
