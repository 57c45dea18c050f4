// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/constraints/every_constraint.hpp"
#include "hopper/planning/model/bounds.hpp"
#include "hopper/planning/model/typical_sizes.hpp"
#include "hopper/planning/plane/jet_rows.hpp"

namespace torquewright::hopper {
namespace {

void add_pitch(const Site& site, const PointVariables& point, double pitch_rad,
               optimization::Program& program) {
  program.add_rows(jet_rows(site.named(constraints::base_upright.name), site.posture(point),
                            {equal_to(pitch_rad)}, {typical::kAngle_rad},
                            BasePitchLaw{&site.model.plane}));
}

void add(const Site& site, optimization::Program& program) {
  if (!site.goal.has_level_base) return;
  add_pitch(site, site.variables().points.front(), 0.0, program);
  Site end = site;
  end.phase = site.mesh.size() - 1;
  add_pitch(end, end.variables().points.back(), site.goal.turn_rad, program);
}

}  // namespace

const Constraint constraints::base_upright{
    "base upright", "rad",
    "over a foot of one point the base is level at the begin, and turned by the task's turn at the "
    "end",
    Where::kMotion, add};

}  // namespace torquewright::hopper
