// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "hopper/planning/constraints/every_constraint.hpp"
#include "hopper/planning/model/bounds.hpp"
#include "hopper/planning/model/typical_sizes.hpp"
#include "hopper/planning/plane/jet_rows.hpp"

namespace torquewright::hopper {
namespace {

/// What the phase before did not have on the ground.
std::vector<dynamics::BodyPoint> new_points(const Site& site) {
  std::vector<dynamics::BodyPoint> out;
  for (const std::size_t i : site.stance().points) {
    const auto had = [&](const Stance& before) {
      return std::find(before.points.begin(), before.points.end(), i) != before.points.end();
    };
    if (site.phase == 0 || !had(site.stance_before())) {
      out.push_back(site.model.plane.sole[i].point);
    }
  }
  return out;
}

void add(const Site& site, optimization::Program& program) {
  // What the foot's own variables hold already needs no rows.
  if (site.stance().holds_place()) return;
  const std::vector<dynamics::BodyPoint> points = new_points(site);
  if (points.empty()) return;
  program.add_rows(
      jet_rows(site.named(constraints::feet_on_the_ground.name),
               numbers_from(site.variables().points.front().position, site.moving()),
               std::vector<optimization::Bounds>(points.size(), equal_to(site.ground_m())),
               std::vector<double>(points.size(), typical::kLength_m),
               PlaceLaw{site.scratch, PlanFrame::kSole, points}));
}

}  // namespace

const Constraint constraints::feet_on_the_ground{
    "feet on the ground", "m",
    "what touches anew is on the ground where its phase begins, unless bounds say so",
    Where::kPhase, add};

}  // namespace torquewright::hopper
