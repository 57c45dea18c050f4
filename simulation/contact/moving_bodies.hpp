// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamics/inverse_dynamics.hpp"
#include "dynamics/mass_matrix.hpp"
#include "dynamics/passive_forces.hpp"
#include "dynamics/tree_state.hpp"

namespace torquewright::simulation {

/// The bodies that a time stepping moves: a tree, and what turns with it (rotors behind
/// mechanisms). One object serves one thread. Vectors as in dynamics::TreeState.
class MovingBodies {
 public:
  virtual ~MovingBodies() = default;

  /// Sets position and velocity. False where a mechanism does not reach the posture; then no other
  /// function may be called.
  [[nodiscard]] virtual bool set(const dynamics::VectorIn& position,
                                 const dynamics::VectorIn& velocity) = 0;
  /// The state that was set last.
  virtual dynamics::TreeState& state() = 0;
  /// Writes the mass matrix (n x n), rotors included.
  virtual void mass_matrix(dynamics::MatrixOut out) = 0;
  /// Writes the forces (n x 1) that hold accelerations at zero, with the joints' dampers and
  /// springs and without their dry friction.
  virtual void bias(dynamics::VectorOut out) = 0;
  /// Writes how fast a joint moves with each velocity (n x 1), by its row: of the tree's own its
  /// own velocity. Rows beyond the velocities are those of joints that move with others.
  virtual void joint_motion(Eigen::Index row, dynamics::VectorOut out) {
    out.setZero();
    out[row] = 1.0;
  }
};

/// A tree without anything that turns with it.
class BareTree final : public MovingBodies {
 public:
  explicit BareTree(dynamics::Tree tree) : state_(std::move(tree)) {}

  bool set(const dynamics::VectorIn& position, const dynamics::VectorIn& velocity) override {
    state_.set(position, velocity);
    return true;
  }
  dynamics::TreeState& state() override { return state_; }
  void mass_matrix(dynamics::MatrixOut out) override { dynamics::mass_matrix(state_, out); }
  void bias(dynamics::VectorOut out) override {
    dynamics::bias(state_, out);
    dynamics::add_dampers_and_springs(state_, out);
  }

 private:
  dynamics::TreeState state_;
};

}  // namespace torquewright::simulation
