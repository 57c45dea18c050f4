// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/LU>

#include "simulation/contact/contact_problem.hpp"

namespace torquewright::simulation {

/// Memory of newton_contacts(), which allocates only where the number of points changes.
struct NewtonMemory {
  Eigen::VectorXd impulse_N_s, velocity_m_s, off_m_s, step_N_s;
  Eigen::MatrixXd slope_1_kg;
  Eigen::PartialPivLU<Eigen::MatrixXd> factors;
};

/// Takes semismooth Newton steps on the projections that the contacts' laws are (Alart and Curnier,
/// "A mixed formulation for frictional contact problems prone to Newton like solution methods",
/// 1991; docs/derivations/time_stepping.md eqs. (9), (10)). Near a solution it arrives in some
/// steps where sweeps creep, as under a foot whose four corners share its load. Among many
/// distributions of a load it takes the shortest change. True: no velocity is off by more than
/// tolerance_m_s. Else impulse_N_s is unchanged.
[[nodiscard]] bool newton_contacts(const ContactProblem& problem, double tolerance_m_s,
                                   NewtonMemory& memory, Eigen::VectorXd& impulse_N_s);

}  // namespace torquewright::simulation
