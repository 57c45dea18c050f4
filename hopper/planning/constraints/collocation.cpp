// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/constraints/every_constraint.hpp"
#include "hopper/planning/model/typical_sizes.hpp"
#include "hopper/planning/plane/hermite_simpson.hpp"

namespace torquewright::hopper {
namespace {

/// x and z (in the plane's order) of the foot where the stance holds them.
bool is_place(const Site& site) { return site.row < 2 && site.stance().holds_place(); }
bool is_pitch(const Site& site) { return site.row == 2 && site.stance().holds_pitch(); }

/// Whether bounds hold the row at all instants: then there is nothing to say of it. Of what a
/// stance holds x alone is open, but at the begin, where it is the origin.
bool is_held(const Site& site) {
  return (is_place(site) && (site.row == 1 || site.phase == 0)) || is_pitch(site);
}

void add_step(const Site& site, std::string_view name, int PointVariables::*y,
              int PointVariables::*rate, double scale, optimization::Program& program) {
  const std::size_t i = site.index;
  const PointVariables& p0 = site.variables().points[2 * i];
  const PointVariables& pm = site.variables().points[2 * i + 1];
  const PointVariables& p1 = site.variables().points[2 * i + 2];
  const std::vector<double>& knots = site.mesh[site.phase].knots;
  const auto r = static_cast<int>(site.row);
  program.add_rows(std::make_unique<HermiteSimpson>(
      site.named(name),
      std::vector<int>{p0.*y + r, pm.*y + r, p1.*y + r, p0.*rate + r, pm.*rate + r, p1.*rate + r,
                       site.variables().duration},
      knots[i + 1] - knots[i], scale));
}

void add_positions(const Site& site, optimization::Program& program) {
  if (is_held(site)) return;
  add_step(site, constraints::positions_go_on.name, &PointVariables::position,
           &PointVariables::velocity, site.row < 2 ? typical::kLength_m : typical::kAngle_rad,
           program);
}

void add_velocities(const Site& site, optimization::Program& program) {
  if (is_held(site) || is_place(site)) return;
  add_step(site, constraints::velocities_go_on.name, &PointVariables::velocity,
           &PointVariables::acceleration, typical::kSpeed, program);
}

}  // namespace

const Constraint constraints::positions_go_on{
    "positions go on", "m or rad",
    "over each interval positions change by the integral of their rates", Where::kStep,
    add_positions};

const Constraint constraints::velocities_go_on{
    "velocities go on", "m/s or rad/s",
    "over each interval velocities change by the integral of the accelerations", Where::kStep,
    add_velocities};

}  // namespace torquewright::hopper
