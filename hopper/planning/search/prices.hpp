// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/planning/programme/flip_program.hpp"
#include "hopper/planning/result/kept_margins.hpp"
#include "hopper/planning/result/plan_result.hpp"
#include "optimization/nonlinear/solve.hpp"

namespace torquewright::hopper {

/// A program that was solved, and what it was made of.
struct SolvedProgram {
  FlipProgram program;
  PlannedMotion guess;
  optimization::NonlinearSolution solution;
};

/// Returns every planning margin, then the longest duration of each kind of phase, and what more of
/// it costs the objective, by the program's multipliers: to first order, on the mesh as it is.
std::vector<BoundPrice> bound_prices(const Robot& robot, const PlanOptions& options,
                                     const SolvedProgram& solved, const KeptMargins& kept);

}  // namespace torquewright::hopper
