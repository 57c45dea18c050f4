// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <string>
#include <vector>

namespace torquewright::hopper {

/// Meaning of the first three rows of a phase's instants: x, z and a pitch, in the world.
enum class PlanFrame {
  /// Rearmost point of the sole, and pitch of the foot: what stands on the ground stands exactly.
  kSole,
  kMass,  ///< Centre of mass, and pitch of the base: what flies falls exactly.
};

/// An instant of a motion in the sagittal plane. After the three rows of the phase's frame comes
/// every joint of the tree; joints that leave the plane stay at 0.
struct PlannedInstant {
  double time_s = 0.0;
  Eigen::VectorXd position;
  Eigen::VectorXd velocity;
  Eigen::VectorXd acceleration;
  /// (drives x 1), torques at the drives' outputs, including what their rotors take.
  Eigen::VectorXd drive_Nm;
  Eigen::Matrix3Xd contact_N;  ///< (3 x contact points of the robot), world's axes, on the robot.
  double bus_V = 0.0;          ///< Voltage of the shared battery; 0 where drives share none.
};

/// A phase in which the same points touch. Instants are the ends and the middles of intervals in
/// turn: 2 n + 1 for n intervals. Within an interval the acceleration is the parabola through its
/// three instants; velocity and position are its integrals, so that they meet the next instant's
/// (Hermite-Simpson: docs/derivations/collocation.md). Torques and forces are the parabolas through
/// theirs.
struct PlannedPhase {
  std::string stance;         ///< Name of the stance: "flat", "heel", "toe", "flight".
  std::vector<bool> touches;  ///< Whether each contact point of the robot touches.
  std::vector<PlannedInstant> instants;
  /// Impulses of the ground where the phase begins with an impact (3 x contact points), else empty.
  Eigen::Matrix3Xd impulse_N_s = {};
  /// Whether the instants obey all that is said here; false for a sketch.
  bool is_collocated = false;

  bool flies() const {
    return std::none_of(touches.begin(), touches.end(), [](bool one) { return one; });
  }
  PlanFrame frame() const { return flies() ? PlanFrame::kMass : PlanFrame::kSole; }
  std::size_t intervals() const { return (instants.size() - 1) / 2; }
  double begin_s() const { return instants.front().time_s; }
  double end_s() const { return instants.back().time_s; }
};

/// Phases in order; one begins where the one before ends, at the same time and position. Where
/// their velocities differ there is an impact of rigid bodies.
struct PlannedMotion {
  std::vector<PlannedPhase> phases;
};

}  // namespace torquewright::hopper
