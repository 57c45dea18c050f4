// SPDX-License-Identifier: Apache-2.0
#include "robot/loops/rod_hinges.hpp"

#include <Eigen/Geometry>
#include <optional>

#include "robot/mechanisms/loop_gaps.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kAlong = 0.1;  // sine of an angle between rod and axis: below, nothing is gained

/// From the ball to what the rod's other end is held by.
std::optional<Vector3d> rod_direction(const LoopGeometry& loop, std::size_t rod) {
  for (const LoopClosure& closure : loop.closures) {
    for (const dynamics::BodyPoint& end : closure) {
      if (end.body == rod && end.p_B_m.norm() > 0) return end.p_B_m.normalized();
    }
  }
  return std::nullopt;
}

}  // namespace

void turn_rod_hinges(const std::vector<std::size_t>& balls, LoopGeometry& loop) {
  dynamics::TreeState state(without_names(loop.tree));
  state.set(loop.start, Eigen::VectorXd::Zero(loop.start.size()));
  for (const std::size_t first : balls) {
    dynamics::Body* hinges = &loop.tree.bodies[first];
    const auto along = rod_direction(loop, first + 2);
    if (!along) continue;
    const Matrix3d R = state.motion(hinges[0].parent).R_WB * hinges[0].joint.R_PB;
    const Vector3d swing = R.transpose() * state.motion(1).axis;
    const Vector3d across = along->cross(swing);
    if (!(across.norm() > kAlong)) continue;
    hinges[0].joint.axis = swing.normalized();
    hinges[1].joint.axis = across.normalized();
    hinges[2].joint.axis = *along;
  }
}

}  // namespace torquewright::hopper
