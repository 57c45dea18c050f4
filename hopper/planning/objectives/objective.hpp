// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "hopper/planning/model/plan_model.hpp"
#include "hopper/planning/model/plan_variables.hpp"

namespace torquewright::hopper {

/// Typical cost of weight 1 in the hopper's flip, measured there for effort. Each objective divides
/// its value by a typical one, so that weights compare objectives, and smoothness (smoothness.hpp)
/// is small beside all of them. For a robot of another size only effort keeps this.
constexpr double kTypicalCost = 0.1;

/// A quantity that a plan can make small or large. Each objective is one file in this folder and
/// one line in every_objective.hpp.
struct Objective {
  std::string_view name;
  std::string_view sentence;  ///< Description for a user of what it does to a plan.
  std::string_view unit;      ///< Unit of the value; empty: a plain number.
  /// Adds costs, lower where the plan is better, and unknowns and rows where it needs them.
  /// io::SpecError where no phase has what it speaks of: a flight, an impact.
  void (*add)(const PlanModel& model, const PlanOptions& options, double weight,
              FlipProgram& program);
  /// Returns the unweighted value, as a user reads it, of any program of these phases, whether it
  /// has the objective's own costs or not. io::SpecError as in add().
  double (*value)(const PlanModel& model, const PlanOptions& options, const FlipProgram& program,
                  const std::vector<double>& values);
};

}  // namespace torquewright::hopper
