// SPDX-License-Identifier: Apache-2.0
#include "hopper/replay/fall.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/point.hpp"
#include "robot/model/touching_point.hpp"

namespace torquewright::hopper {
namespace {

bool is_foot(const Robot& robot, std::size_t body) {
  return std::any_of(robot.contacts.begin(), robot.contacts.end(),
                     [body](const ContactPoint& one) { return one.point.body == body; });
}

/// Above the ground.
double height_m(const dynamics::TreeState& state, const dynamics::BodyPoint& point,
                const WalkedGround& ground) {
  const Eigen::Vector3d place_m = dynamics::point_position_m(state, point);
  return place_m.z() - ground.at_m(place_m.x());
}

/// A foot on soft ground sinks by less.
constexpr double kStruck_m = 5e-3;

/// How far the point is inside the ground from the nearest edge where that falls away; infinite
/// where it does not.
double from_face_m(const simulation::GroundProfile& ground, double x_m) {
  const auto& [edges_m, heights_m] = ground;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < edges_m.size(); ++i) {
    const bool is_right = x_m >= edges_m[i];
    const bool falls_away =
        is_right ? heights_m[i] < heights_m[i + 1] : heights_m[i + 1] < heights_m[i];
    if (falls_away) nearest_m = std::min(nearest_m, std::abs(x_m - edges_m[i]));
  }
  return nearest_m;
}

}  // namespace

std::optional<std::string> fallen(const Robot& robot, const dynamics::TreeState& state,
                                  const WalkedGround& ground) {
  for (std::size_t body = 0; body < robot.tree.bodies.size(); ++body) {
    const dynamics::Body& one = robot.tree.bodies[body];
    if (is_foot(robot, body)) continue;
    if (height_m(state, {body}, ground) < 0.0) {
      return fmt::format("the {}'s {} is on the ground", one.name,
                         body == 0 ? "origin" : "joint " + one.joint.name);
    }
    if (height_m(state, {body, one.inertia.center_of_mass_m}, ground) < 0.0) {
      return fmt::format("the {}'s centre of mass is on the ground", one.name);
    }
  }
  for (const CollisionSphere& sphere : robot.spheres) {
    if (is_foot(robot, sphere.center.body)) continue;
    if (height_m(state, sphere.center, ground) < sphere.radius_m) {
      return fmt::format("a collision sphere of the {} is on the ground",
                         robot.tree.bodies[sphere.center.body].name);
    }
  }
  return std::nullopt;
}

std::optional<std::string> struck(const Robot& robot, const dynamics::TreeState& state,
                                  const WalkedGround& ground) {
  if (ground.profile.is_flat()) return std::nullopt;
  const auto point = buried(robot, state, ground, kStruck_m);
  if (!point) return std::nullopt;
  const ContactPoint& contact = robot.contacts[point->contact];
  const double x_m = dynamics::point_position_m(state, touching_point(contact, state)).x();
  if (from_face_m(ground.profile, x_m) > point->depth_m) return std::nullopt;
  return fmt::format("{} strikes an edge of the ground, {:.0f} mm below its top", contact.name,
                     1e3 * point->depth_m);
}

std::optional<BuriedPoint> buried(const Robot& robot, const dynamics::TreeState& state,
                                  const WalkedGround& ground, double allowed_m) {
  std::optional<BuriedPoint> deepest;
  for (std::size_t i = 0; i < robot.contacts.size(); ++i) {
    const double depth_m = -height_m(state, touching_point(robot.contacts[i], state), ground);
    if (depth_m > std::max(allowed_m, deepest ? deepest->depth_m : 0.0)) deepest = {i, depth_m};
  }
  return deepest;
}

}  // namespace torquewright::hopper
