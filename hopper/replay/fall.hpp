// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "dynamics/tree_state.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Returns which body that is no foot has come to the ground, as the end of a sentence: "the
/// thigh's centre of mass is on the ground". A foot is a body with a contact point. Of the others
/// the origin (which is at its joint), the centre of mass, and the collision spheres count:
/// documents hold no more of a body's shape.
std::optional<std::string> fallen(const Robot& robot, const dynamics::TreeState& state,
                                  double ground_height_m);

/// The contact point that lies deepest below the ground, beyond a limit, with its depth in m.
struct BuriedPoint {
  std::size_t contact = 0;
  double depth_m = 0.0;
};
std::optional<BuriedPoint> buried(const Robot& robot, const dynamics::TreeState& state,
                                  double ground_height_m, double allowed_m);

}  // namespace torquewright::hopper
