// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hopper/planning/tasks/plan_goal.hpp"
#include "optimization/nonlinear/program.hpp"

namespace torquewright::hopper {

/// Numbers of the first unknowns of one instant in the program.
struct PointVariables {
  int position = 0;      ///< Position (m): the phase's frame, then the joints that move.
  int velocity = 0;      ///< (m)
  int acceleration = 0;  ///< (m)
  int drives = 0;        ///< (d)
  int forces = 0;        ///< (f of the stance)
  int bus = 0;           ///< Bus voltages, one for each supply that has a resistance.
};

struct PhaseVariables {
  int duration = 0;
  std::vector<PointVariables> points;  ///< Knots and middles in turn: 2 n + 1.
  int impulses = 0;                    ///< Impulses (f of the stance) at its beginning.
  bool has_impact = false;             ///< Whether it begins with an impact.
  int velocity_before = 0;             ///< Velocity before that impact, in this phase's frame.
};

/// A nonlinear program and the meaning of its unknowns.
struct FlipProgram {
  optimization::Program program;
  std::vector<MeshPhase> mesh;
  std::vector<PhaseVariables> phases;
};

}  // namespace torquewright::hopper
