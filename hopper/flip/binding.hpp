// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/flip/plan_result.hpp"
#include "hopper/flip/plan_variables.hpp"
#include "optimization/nonlinear/solve.hpp"

namespace torquewright::hopper {

/// What holds a plan back: rows and unknowns that stand at a bound that is no equation, or beyond
/// it, by stance and name, over the instants at which they do. The most often binding first.
std::vector<BindingConstraint> binding_constraints(
    const FlipProgram& program, const PlannedMotion& plan,
    const optimization::NonlinearSolution& solution);

}  // namespace torquewright::hopper
