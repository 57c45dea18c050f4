// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hopper/planning/constraints/site.hpp"

namespace torquewright::hopper {

/// The sites at which a constraint is asked. Rows stand in this order: phase by phase its steps,
/// its instants with the joints of each, the phase; then the motion. At one site they go by the
/// list.
enum class Where {
  kStep,     ///< Each moving row (Site::row) of each interval (Site::index).
  kInstant,  ///< Each instant (Site::index).
  kJoint,    ///< Each joint that moves (Site::row) at each instant, before that.
  kPhase,    ///< Each phase, at its begin.
  kMotion,   ///< Once; Site::phase is 0.
};

/// A limit at a site and what a plan leaves of it, in the constraint's unit.
struct PlanLimit {
  std::string name;   ///< "knee: region".
  double room = 0.0;  ///< Below 0: it is passed by that much. Infinite: there is no limit.
  double size = 0.0;  ///< What is near is told by it.
};

/// What a plan must obey. One file each in this folder, or a few that are one idea, and one line
/// in every_constraint.hpp. docs/derivations/collocation.md
struct Constraint {
  std::string_view name;      ///< Of its rows, after their stance: "heel: impact".
  std::string_view unit;      ///< Of its limits, or of its rows where it states none.
  std::string_view sentence;  ///< What it asks of a plan, for a person.
  Where where;
  /// Adds its rows, and unknowns where it needs them. Null: bounds of the unknowns keep it.
  void (*add)(const Site& site, optimization::Program& program) = nullptr;
  /// What holds a plan back, found in values of the program: of joints, instants and phases. Null:
  /// an equation, or a limit that is told only where it is violated.
  std::vector<PlanLimit> (*limits)(const Site& site, const std::vector<double>& values) = nullptr;
};

}  // namespace torquewright::hopper
