// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "hopper/planning/constraints/every_constraint.hpp"
#include "hopper/planning/model/bounds.hpp"
#include "hopper/planning/model/typical_sizes.hpp"
#include "hopper/planning/plane/jet_rows.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kClear_m = 0.03;     // bodies that must not touch
constexpr double kWeighty_kg = 0.01;  // bodies that are more than a frame

/// Points and how high they are at least.
struct Heights {
  std::vector<dynamics::BodyPoint> points;
  std::vector<optimization::Bounds> bounds;

  void add(const dynamics::BodyPoint& point, double least_m) {
    points.push_back(point);
    bounds.push_back(at_least(least_m));
  }
};

/// Centres of mass and joints, but for the foot's.
void add_bodies(const SagittalRobot& plane, Heights& heights) {
  const dynamics::Tree& tree = plane.robot.tree;
  for (std::size_t body = 0; body < tree.bodies.size(); ++body) {
    if (body == plane.foot || tree.bodies[body].inertia.mass_kg < kWeighty_kg) continue;
    heights.add({body, tree.bodies[body].inertia.center_of_mass_m}, kClear_m);
    heights.add({body, Eigen::Vector3d::Zero()}, kClear_m);
  }
}

/// A point of the sole that is on the ground there. One that was or will be on it is there at the
/// phase's ends too; of the rearmost a variable says so where the foot is the frame.
bool touches(const Site& site, std::size_t point) {
  if (point == 0 && site.stance().frame() == PlanFrame::kSole) return true;
  const auto touches_in = [&](std::size_t phase) {
    const std::vector<std::size_t>& points = site.mesh[phase].stance.points;
    return std::find(points.begin(), points.end(), point) != points.end();
  };
  const bool is_first = site.index == 0;
  const bool is_last = site.index + 1 == site.variables().points.size();
  return touches_in(site.phase) || (is_first && site.phase > 0 && touches_in(site.phase - 1)) ||
         (is_last && !site.is_last_phase() && touches_in(site.phase + 1));
}

void add(const Site& site, optimization::Program& program) {
  Heights heights;
  if (site.index % 2 == 0) add_bodies(site.model.plane, heights);
  for (std::size_t i = 0; i < site.model.plane.sole.size(); ++i) {
    if (!touches(site, i)) heights.add(site.model.plane.sole[i].point, 0.0);
  }
  if (heights.points.empty()) return;
  const std::size_t rows = heights.bounds.size();
  program.add_rows(
      jet_rows(site.named(constraints::above_the_ground.name),
               numbers_from(site.point().position, site.moving()), std::move(heights.bounds),
               std::vector<double>(rows, typical::kLength_m),
               PlaceLaw{site.scratch, site.stance().frame(), std::move(heights.points)}));
}

}  // namespace

const Constraint constraints::above_the_ground{
    "above the ground", "m",
    "points of the sole that do not touch are above the ground, joints and centres of mass of the "
    "other bodies by 3 cm",
    Where::kInstant, add};

}  // namespace torquewright::hopper
