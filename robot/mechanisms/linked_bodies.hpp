// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <vector>

#include "robot/mechanisms/closed_links.hpp"

namespace torquewright::hopper {

/// A loop of a robot, and the bodies of its tree that the loop's own joints carry.
struct HeldLoop {
  const ClosedLinks* links = nullptr;
  std::vector<std::size_t> joints;
};

/// A robot's bodies together with the links of its loops, which move as its own joints say: with N,
/// the speeds of all joints over the robot's own, M = N^T M_all N and f = N^T f_all(N a + N' v).
/// docs/derivations/mechanisms.md eq. (16). Vectors per velocity of the robot's own tree.
template <typename T>
class LinkedBodiesOf {
 public:
  /// Loops without weight, friction or springs are left out: is_empty() where all are.
  LinkedBodiesOf(const dynamics::Tree& tree, std::vector<HeldLoop> loops);

  bool is_empty() const { return loops_.empty(); }
  const std::vector<HeldLoop>& loops() const { return loops_; }
  /// `followed` by loop.
  void set(const dynamics::VectorInOf<T>& position, const dynamics::VectorInOf<T>& velocity,
           const std::vector<FollowedOf<T>>& followed);
  /// (n x n)
  void mass_matrix(dynamics::MatrixOutOf<T> out);
  void inverse_dynamics(const dynamics::VectorInOf<T>& acceleration,
                        dynamics::VectorOutOf<T> force);
  /// Of all joints, the robot's own too.
  void add_dampers_and_springs(dynamics::VectorOutOf<T> force) const;
  /// Adds what dry friction takes of joints that move or begin to, the robot's own too.
  void add_dry_friction(const dynamics::VectorIn& acceleration,
                        dynamics::VectorOut force) const requires std::same_as<T, double>;
  /// Writes what dry friction of joints that rest and stay so holds of needed forces (n x 1): the
  /// nearest to them that the joints' limits, over the robot's own velocities, allow.
  void held_by_friction(const dynamics::VectorIn& acceleration, const dynamics::VectorIn& needed,
                        dynamics::VectorOut held) const requires std::same_as<T, double>;
  /// How fast each joint, links' behind the robot's own, moves with each velocity (m x n): N.
  const Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>& motions() const { return motions_; }
  /// All bodies as they stand and move.
  dynamics::TreeStateOf<T>& state() { return state_; }
  const dynamics::TreeStateOf<T>& state() const { return state_; }

 private:
  std::vector<HeldLoop> loops_;
  std::vector<Eigen::Index> first_row_;  ///< Of each loop's links.
  dynamics::TreeStateOf<T> state_;
  Eigen::Index size_;  ///< Velocities of the robot's own.
  Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> motions_;
  dynamics::VectorX<T> bent_;  ///< N' v
};

}  // namespace torquewright::hopper
