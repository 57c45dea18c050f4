// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "gearbox/constraints/design_report.hpp"
#include "gearbox/floors.hpp"
#include "optimization/discrete/problem.hpp"

namespace torquewright::gearbox {

/// The floors and ceilings that the problem states, at a design that is described.
std::vector<ConstraintReport> floor_constraints(const Problem& problem, const DesignReport& report);

/// What they limit, by the variables of a model.
struct FloorGoals {
  std::function<optimization::Goal(Objective)> of_objective;
  optimization::Goal backlash;
};

/// Adds them to a model, with the question how far each would have to move.
void add_floors(const Problem& problem, const FloorGoals& goals, optimization::Problem& model);

/// 4/(m z cos alpha), which is the backlash of gears without profile shift: z is O in a 3k, S + R
/// in a planetary (docs/gearbox_constraints.md, "Floors and ceilings").
optimization::Goal backlash_goal(const Rational& module_mm, const optimization::Expression& teeth);

}  // namespace torquewright::gearbox
