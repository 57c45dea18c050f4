// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "dynamics/tree_state.hpp"
#include "robot/model/robot.hpp"
#include "simulation/contact/ground_profile.hpp"

namespace torquewright::hopper {

/// The ground of a run.
struct WalkedGround {
  double height_m = 0.0;
  const simulation::GroundProfile& profile;  ///< Over that height.

  double at_m(double x_m) const { return height_m + profile.height_m(x_m); }
};

/// Returns which body that is no foot has come to the ground, as the end of a sentence: "the
/// thigh's centre of mass is on the ground". A foot is a body with a contact point. Of the others
/// the origin (which is at its joint), the centre of mass, and the collision spheres count:
/// documents hold no more of a body's shape.
std::optional<std::string> fallen(const Robot& robot, const dynamics::TreeState& state,
                                  const WalkedGround& ground);

/// Returns which contact point has run into the face of an edge of the ground, as the end of a
/// sentence: it is nearer to the face than to the top above it, and deeper below that than a foot
/// sinks. An engine whose ground has no faces would let it on.
std::optional<std::string> struck(const Robot& robot, const dynamics::TreeState& state,
                                  const WalkedGround& ground);

/// The contact point that lies deepest below the ground, beyond a limit, with its depth in m.
struct BuriedPoint {
  std::size_t contact = 0;
  double depth_m = 0.0;
};
std::optional<BuriedPoint> buried(const Robot& robot, const dynamics::TreeState& state,
                                  const WalkedGround& ground, double allowed_m);

}  // namespace torquewright::hopper
