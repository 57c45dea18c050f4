// SPDX-License-Identifier: Apache-2.0
#include "hopper/replay/fall.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "dynamics/point.hpp"
#include "robot/model/touching_point.hpp"

namespace torquewright::hopper {
namespace {

bool is_foot(const Robot& robot, std::size_t body) {
  return std::any_of(robot.contacts.begin(), robot.contacts.end(),
                     [body](const ContactPoint& one) { return one.point.body == body; });
}

double height_m(const dynamics::TreeState& state, const dynamics::BodyPoint& point) {
  return dynamics::point_position_m(state, point).z();
}

}  // namespace

std::optional<std::string> fallen(const Robot& robot, const dynamics::TreeState& state,
                                  double ground_height_m) {
  for (std::size_t body = 0; body < robot.tree.bodies.size(); ++body) {
    const dynamics::Body& one = robot.tree.bodies[body];
    if (is_foot(robot, body)) continue;
    if (height_m(state, {body}) < ground_height_m) {
      return fmt::format("the {}'s {} is on the ground", one.name,
                         body == 0 ? "origin" : "joint " + one.joint.name);
    }
    if (height_m(state, {body, one.inertia.center_of_mass_m}) < ground_height_m) {
      return fmt::format("the {}'s centre of mass is on the ground", one.name);
    }
  }
  for (const CollisionSphere& sphere : robot.spheres) {
    if (is_foot(robot, sphere.center.body)) continue;
    if (height_m(state, sphere.center) - sphere.radius_m < ground_height_m) {
      return fmt::format("a collision sphere of the {} is on the ground",
                         robot.tree.bodies[sphere.center.body].name);
    }
  }
  return std::nullopt;
}

std::optional<BuriedPoint> buried(const Robot& robot, const dynamics::TreeState& state,
                                  double ground_height_m, double allowed_m) {
  std::optional<BuriedPoint> deepest;
  for (std::size_t i = 0; i < robot.contacts.size(); ++i) {
    const double depth_m =
        ground_height_m - height_m(state, touching_point(robot.contacts[i], state));
    if (depth_m > std::max(allowed_m, deepest ? deepest->depth_m : 0.0)) deepest = {i, depth_m};
  }
  return deepest;
}

}  // namespace torquewright::hopper
