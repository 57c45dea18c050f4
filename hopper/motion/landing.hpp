// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "dynamics/tree.hpp"

namespace torquewright::hopper {

/// When and where along the ground the base was at a landing, and which way it faced: a unit vector
/// at right angles to its lateral axis, which pitch does not turn; of a planar base along x.
struct Landing {
  double time_s = 0.0;
  Eigen::Vector2d place_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d forward = Eigen::Vector2d::UnitX();
};

/// Requires a base that moves.
Landing landing_at(const dynamics::Tree& tree, double time_s, const Eigen::VectorXd& position);

/// How far the base went from one landing to the next along the way that it faced at the first.
double hopped_m(const Landing& from, const Landing& to);

/// That way over the time that it took.
double hop_speed_m_s(const Landing& from, const Landing& to);

}  // namespace torquewright::hopper
