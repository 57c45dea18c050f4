// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "hopper/planning/constraints/every_constraint.hpp"
#include "hopper/planning/model/bounds.hpp"
#include "hopper/planning/model/typical_sizes.hpp"
#include "hopper/planning/plane/jet_rows.hpp"

namespace torquewright::hopper {
namespace {

/// Where a phase's frame is another than that of the phase before.
void add(const Site& site, optimization::Program& program) {
  if (site.phase == 0 || site.stance().frame() == site.stance_before().frame()) return;
  const Eigen::Index m = site.moving();
  const PointVariables& before = site.phases[site.phase - 1].points.back();
  const PointVariables& after = site.variables().points.front();
  const bool lands = site.stance().frame() == PlanFrame::kSole;
  const PointVariables& sole = lands ? after : before;
  const PointVariables& mass = lands ? before : after;
  const int sole_velocity = lands ? site.variables().velocity_before : sole.velocity;
  std::vector<double> scales(static_cast<std::size_t>(2 * m), typical::kSpeed);
  std::fill_n(scales.begin(), m, typical::kLength_m);
  program.add_rows(
      jet_rows(site.named(constraints::goes_on.name),
               in_order({numbers_from(sole.position, m), numbers_from(sole_velocity, m),
                         numbers_from(mass.position, m), numbers_from(mass.velocity, m)}),
               std::vector<optimization::Bounds>(scales.size(), equal_to(0.0)), scales,
               LinkLaw{site.scratch}));
}

}  // namespace

const Constraint constraints::goes_on{
    "goes on", "m, rad, m/s or rad/s",
    "at take-off and touch-down the foot's frame and the mass's say the same of place and velocity",
    Where::kPhase, add};

}  // namespace torquewright::hopper
