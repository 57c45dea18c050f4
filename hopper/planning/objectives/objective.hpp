// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "hopper/planning/model/plan_model.hpp"
#include "hopper/planning/model/plan_variables.hpp"

namespace torquewright::hopper {

/// What a cost of weight 1 is in the hopper's flip, or near it: what effort is there. Each
/// objective divides its value by a typical one, so that weights compare objectives and smoothness
/// (smoothness.hpp) is small beside all of them. Of a robot of another size effort alone keeps it.
constexpr double kTypicalCost = 0.1;

/// What a plan can do as little or as much of as possible. One file each in this folder, one line
/// in every_objective.hpp.
struct Objective {
  std::string_view name;
  std::string_view sentence;  ///< What it does to a plan, for a person.
  std::string_view unit;      ///< Of the value; empty: a plain number.
  /// Adds costs, lower where the plan is better, and unknowns and rows where it needs them.
  /// io::SpecError where no phase has what it speaks of: a flight, an impact.
  void (*add)(const PlanModel& model, const PlanOptions& options, double weight,
              FlipProgram& program);
  /// Unweighted, as a user reads it. Of any program of these phases, its own costs in it or not.
  /// io::SpecError as in add().
  double (*value)(const PlanModel& model, const PlanOptions& options, const FlipProgram& program,
                  const std::vector<double>& values);
};

}  // namespace torquewright::hopper
