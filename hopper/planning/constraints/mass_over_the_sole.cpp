// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>

#include "hopper/planning/constraints/every_constraint.hpp"
#include "hopper/planning/model/typical_sizes.hpp"
#include "hopper/planning/plane/jet_rows.hpp"

namespace torquewright::hopper {
namespace {

/// At this share of the foot from either end.
optimization::Bounds within(const Site& site, double share) {
  const double length_m = site.model.foot_length_m;
  return {share * length_m, (1.0 - share) * length_m};
}

/// Where the last stance begins after a landing on an edge, the mass is over the sole already, as
/// far as the load has to be: else it creeps there over the edge, which no feedback can help
/// (trial: plans without this fell back in most replays).
void add_mass(const Site& site, optimization::Program& program) {
  Site last = site;
  last.phase = site.mesh.size() - 1;
  if (last.phase == 0 || !last.stance().is_flat() || last.stance_before().points.size() != 1) {
    return;
  }
  program.add_rows(jet_rows(last.named(constraints::mass_over_the_sole.name),
                            last.posture(last.variables().points.front()),
                            {within(site, site.options.margins.center_of_pressure)},
                            {typical::kLength_m}, LeanLaw{site.scratch}));
}

/// Where the last stance begins, on a whole sole.
bool asks_capture(const Site& site) {
  return site.index == 0 && site.is_last_phase() && site.stance().is_flat() &&
         site.options.margins.capture_point > 0.0;
}

std::vector<int> capture_numbers(const Site& site) {
  return in_order({site.posture(site.point()), site.posture_rates(site.point())});
}

void add_capture(const Site& site, optimization::Program& program) {
  if (!asks_capture(site)) return;
  program.add_rows(jet_rows(site.named(constraints::capture_point.name), capture_numbers(site),
                            {within(site, site.options.margins.capture_point)},
                            {typical::kLength_m}, CaptureLaw{site.scratch}));
}

std::vector<PlanLimit> capture_limits(const Site& site, const std::vector<double>& values) {
  if (!asks_capture(site)) return {};
  const std::vector<int> variables = capture_numbers(site);
  Eigen::VectorXd x(static_cast<Eigen::Index>(variables.size())), at(1);
  for (std::size_t i = 0; i < variables.size(); ++i) {
    x[static_cast<Eigen::Index>(i)] = values[static_cast<std::size_t>(variables[i])];
  }
  CaptureLaw{std::make_shared<SagittalScratch>(site.model.plane)}(x, at);
  const optimization::Bounds bounds = within(site, site.options.margins.capture_point);
  return {{"capture point", std::min(at[0] - bounds.lower, bounds.upper - at[0]),
           site.model.foot_length_m}};
}

}  // namespace

const Constraint constraints::mass_over_the_sole{
    "mass over the sole", "m",
    "after a landing on an edge the mass is over the sole where the last stance begins",
    Where::kMotion, add_mass};

const Constraint constraints::capture_point{
    "capture point",
    "m",
    "where asked for, the point over which the mass comes to rest by itself is within the sole "
    "where the last stance begins",
    Where::kInstant,
    add_capture,
    capture_limits};

}  // namespace torquewright::hopper
