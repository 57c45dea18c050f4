// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/programme/flip_program.hpp"

#include "hopper/planning/constraints/library.hpp"
#include "hopper/planning/objectives/library.hpp"
#include "hopper/planning/programme/smoothness.hpp"
#include "hopper/planning/programme/unknowns.hpp"

namespace torquewright::hopper {
namespace {

/// The solver's path depends on the order of rows: it is the one that Where states.
void add_constraints(Site site, optimization::Program& program) {
  const auto ask = [&](Where where) {
    for (const Constraint* one : every_constraint()) {
      if (one->where == where && one->add != nullptr) one->add(site, program);
    }
  };
  const auto ask_rows = [&](Where where, Eigen::Index rows) {
    for (site.row = 0; site.row < rows; ++site.row) ask(where);
    site.row = 0;
  };
  for (site.phase = 0; site.phase < site.mesh.size(); ++site.phase) {
    const MeshPhase& mesh = site.mesh[site.phase];
    for (site.index = 0; site.index < mesh.intervals(); ++site.index) {
      ask_rows(Where::kStep, site.moving());
    }
    for (site.index = 0; site.index < mesh.points(); ++site.index) {
      ask_rows(Where::kJoint, site.joints());
      ask(Where::kInstant);
    }
    site.index = 0;
    ask(Where::kPhase);
  }
  site.phase = 0;
  ask(Where::kMotion);
}

}  // namespace

FlipProgram flip_program(const PlanModel& model, const std::vector<MeshPhase>& mesh,
                         const PlanGoal& goal, const PlanOptions& options,
                         const PlannedMotion& guess) {
  FlipProgram out;
  out.mesh = mesh;
  add_unknowns(model, goal, guess, out);
  add_constraints(
      {model, goal, options, out.mesh, out.phases, std::make_shared<SagittalScratch>(model.plane)},
      out.program);
  for (const WeightedObjective& one : objectives_of(options)) {
    objective_named(one.name).add(model, options, one.weight, out);
  }
  add_smoothness(model, out);
  return out;
}

}  // namespace torquewright::hopper
