// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "learning/environment.hpp"

namespace torquewright::learning {

/// x' = A x + B u, each step earns -(x' Q x + u' R u): a cart on a line, state position and speed.
struct LinearQuadratic {
  Eigen::Matrix2d A{{1.0, 0.1}, {0.0, 1.0}};
  Eigen::Vector2d B{0.005, 0.1};
  Eigen::Matrix2d Q{{1.0, 0.0}, {0.0, 0.1}};
  double R = 0.1;
  double discount = 0.95;
  int steps = 40;            ///< Then the time is up.
  bool is_split = false;     ///< Two heads: states, and actions.
  bool hides_speed = false;  ///< The actor sees where it is and was, the critic the speed as well.
};

/// u = -K x of the greatest discounted sum without end, by iterating Riccati's equation.
Eigen::RowVector2d riccati_gain(const LinearQuadratic& task);

Sizes sizes_of(const LinearQuadratic& task);
MakeEnvironment environments_of(const LinearQuadratic& task);

/// Discounted cost of that many steps of u = -K x, from x.
double cost_of_gain(const LinearQuadratic& task, const Eigen::RowVector2d& gain, Eigen::Vector2d x,
                    int steps);

}  // namespace torquewright::learning
