// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hopper/planning/tasks/plan_goal.hpp"
#include "optimization/nonlinear/program.hpp"

namespace torquewright::hopper {

/// Where the unknowns of one instant begin in the program.
struct PointVariables {
  int position = 0;      ///< (m) of the phase's frame, then the joints that move.
  int velocity = 0;      ///< (m)
  int acceleration = 0;  ///< (m)
  int drives = 0;        ///< (d)
  int forces = 0;        ///< (f of the stance)
  int bus = 0;           ///< One a supply that has a resistance.
};

struct PhaseVariables {
  int duration = 0;
  std::vector<PointVariables> points;  ///< Knots and middles in turn: 2 n + 1.
  int impulses = 0;                    ///< (f of the stance) at its begin,
  bool has_impact = false;             ///< where it begins with an impact,
  int velocity_before = 0;             ///< and the velocity before it, in this phase's frame.
};

/// A nonlinear program and where its unknowns stand for what.
struct FlipProgram {
  optimization::Program program;
  std::vector<MeshPhase> mesh;
  std::vector<PhaseVariables> phases;
};

}  // namespace torquewright::hopper
