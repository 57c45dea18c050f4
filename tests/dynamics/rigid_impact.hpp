// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "dynamics/point.hpp"

namespace torquewright::test {

/// A point that meets something that does not move.
struct Contact {
  dynamics::BodyPoint point = {};
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< Unit vector out of the ground, world.
  double friction_coefficient = 0;                    ///< Impulse along the ground over normal one.
  double restitution = 0;  ///< Speed away over speed of approach, 0 to 1.
};

enum class ImpactStatus {
  kSolved,
  kNotConverged,  ///< The sweeps ended before the impulses stood still; they are the last ones.
  kNoInertia,     ///< The mass matrix is not positive definite; nothing else is set.
};

struct Impact {
  ImpactStatus status = ImpactStatus::kNoInertia;
  Eigen::VectorXd velocity;                   ///< After the impact.
  std::vector<Eigen::Vector3d> impulses_N_s;  ///< On each point, world's axes.
  /// J^T of all impulses, per velocity: Nm s at revolute joints. What the gears must pass on.
  Eigen::VectorXd generalized_impulse;
  double lost_energy_J = 0;  ///< Negative where restitution with friction made energy (Kane 1984).
  int sweeps = 0;
};

/// Rigid impact of the state's velocity on all contacts at once: positions stand, velocities jump,
/// reflected inertias included, all finite forces (gravity, motors) too small to count. Each
/// contact keeps, with v its point's velocity before (-) and after (+) and p the impulse on it,
///
///   0 <= p_n  and  v_n+ + e min(v_n-, 0) >= 0, one of them zero                  (restitution)
///   |p_t| <= mu p_n, and where v_t+ is not zero p_t = -mu p_n v_t+/|v_t+|        (Coulomb's cone)
///
/// docs/derivations/impact.md. Points of one body may share their impulse in more than one way:
/// then only their sum and moment are determined, and how it is shared is where the sweeps ended.
/// std::invalid_argument: a normal that is not a unit vector, a friction coefficient that is
/// negative, a restitution outside [0, 1]. Allocates.
[[nodiscard]] Impact impact(dynamics::TreeState& state, std::span<const Contact> contacts);

}  // namespace torquewright::test
