// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hopper/planning/plane/sagittal_robot.hpp"
#include "hopper/planning/plane/stance.hpp"

namespace torquewright::hopper {

/// How far a plan's phase is from what its torques do.
struct PhaseError {
  /// The greatest difference of an angle or joint at the end of an interval, the equations of
  /// motion integrated over the whole phase from its first instant on.
  double whole_rad = 0.0;
  /// The same by interval, where each begins anew at its own first instant: with the difference of
  /// velocities times the interval, which a position does not show yet.
  std::vector<double> interval_rad;
  /// The greatest moment of each interval, a quarter of the way from either end, that the ground
  /// would have to give beside what the contact points can. It vanishes at ends and middles alone.
  std::vector<double> unexplained_Nm;

  double greatest_unexplained_Nm() const;
};

/// Errors of each phase by classical Runge-Kutta of fourth order, `steps` an interval, of the
/// equations of motion under the plan's torques (parabolas within intervals), what touches held:
/// nothing of the collocation is in it but the torques. docs/derivations/collocation.md, "Error".
std::vector<PhaseError> integration_errors(const SagittalRobot& robot,
                                           const std::vector<Stance>& stances,
                                           const PlannedMotion& plan, int steps = 8);

}  // namespace torquewright::hopper
