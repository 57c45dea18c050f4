// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "hopper/planning/constraints/every_constraint.hpp"
#include "hopper/planning/model/bounds.hpp"
#include "hopper/planning/model/typical_sizes.hpp"
#include "hopper/planning/plane/jet_rows.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kClear_m = 0.03;  // bodies that must not touch
// An edge of the ground is met as a ramp before it, of instants that lie some 4 mm apart.
constexpr double kRamp_m = 0.03;
constexpr double kCorner_m = 5e-3;    // between the ramp and the edge
constexpr int kPiecesOfSole = 5;      // of a sole over an edge
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

/// From 0 to 1 as a share does, with slopes and curvatures that do not jump.
template <typename T>
T smooth(const T& share) {
  if (!(share > T(0.0))) return T(0.0);
  if (share > T(1.0)) return T(1.0);
  return share * share * share * (share * (share * 6.0 - 15.0) + 10.0);
}

/// Height of points over ground that rises ahead of its edges and falls behind them, so that it is
/// nowhere lower than the ground itself, with a ridge on each edge. Variables: position in the
/// frame (m). Rows: one a point.
struct OverEdgesLaw {
  PlaceLaw place;
  simulation::GroundProfile ground;
  double ramp_m = 0.0;   ///< How long a rise takes.
  double ridge_m = 0.0;  ///< What is kept above an edge.

  template <typename T>
  T ground_at(const T& x_m) const {
    T height_m(ground.heights_m.front());
    for (std::size_t i = 0; i < ground.edges_x_m.size(); ++i) {
      const double rise_m = ground.heights_m[i + 1] - ground.heights_m[i];
      const T to_edge_m = x_m - ground.edges_x_m[i];
      const T ahead = smooth<T>((to_edge_m + (ramp_m + kCorner_m)) * (1.0 / ramp_m));
      const T behind = smooth<T>((to_edge_m - kCorner_m) * (1.0 / ramp_m));
      height_m += (rise_m > 0.0 ? ahead : behind) * rise_m + (ahead - behind) * ridge_m;
    }
    return height_m;
  }

  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    SagittalDynamicsOf<T>& body = place.scratch->on<T>();
    body.set(place.frame, x, dynamics::VectorX<T>::Zero(x.size()));
    for (std::size_t i = 0; i < place.points.size(); ++i) {
      const auto at_m = body.place_m(place.points[i]);
      rows[static_cast<Eigen::Index>(i)] = at_m[1] - ground_at<T>(at_m[0]);
    }
  }
};

/// The sole between its ends, which may meet an edge where neither of them does.
void add_sole_between(const SagittalRobot& plane, Heights& heights) {
  const dynamics::BodyPoint &rear = plane.sole.front().point, &front = plane.sole.back().point;
  for (int i = 1; i < kPiecesOfSole; ++i) {
    const double share = static_cast<double>(i) / kPiecesOfSole;
    heights.add({rear.body, rear.p_B_m + share * (front.p_B_m - rear.p_B_m)}, 0.0);
  }
}

void add_rows(const Site& site, Heights heights, optimization::Program& program) {
  const std::size_t rows = heights.bounds.size();
  PlaceLaw place{site.scratch, site.stance().frame(), std::move(heights.points)};
  const std::string name = site.named(constraints::above_the_ground.name);
  const std::vector<int> position = numbers_from(site.point().position, site.moving());
  const std::vector<double> scales(rows, typical::kLength_m);
  if (site.stance().is_flight() && !site.goal.ground.is_flat()) {
    program.add_rows(jet_rows(
        name, position, std::move(heights.bounds), scales,
        OverEdgesLaw{std::move(place), site.goal.ground, kRamp_m, site.options.margins.edge_m}));
    return;
  }
  for (optimization::Bounds& bounds : heights.bounds) bounds.lower += site.ground_m();
  program.add_rows(jet_rows(name, position, std::move(heights.bounds), scales, std::move(place)));
}

void add(const Site& site, optimization::Program& program) {
  Heights heights;
  if (site.index % 2 == 0) add_bodies(site.model.plane, heights);
  for (std::size_t i = 0; i < site.model.plane.sole.size(); ++i) {
    if (!touches(site, i)) heights.add(site.model.plane.sole[i].point, 0.0);
  }
  if (site.stance().is_flight() && !site.goal.ground.is_flat()) {
    add_sole_between(site.model.plane, heights);
  }
  if (!heights.points.empty()) add_rows(site, std::move(heights), program);
}

}  // namespace

const Constraint constraints::above_the_ground{
    "above the ground", "m",
    "points of the sole that do not touch are above the ground, joints and centres of mass of the "
    "other bodies by 3 cm",
    Where::kInstant, add};

}  // namespace torquewright::hopper
