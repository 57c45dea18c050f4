// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/contact/contact_newton.hpp"
#include "simulation/contact/contact_problem.hpp"

namespace torquewright::simulation {

/// Finds impulses with which each point obeys the law of coulomb_impulse_N_s() while all others
/// act, by sweeps over the points (nonsmooth Gauss-Seidel: Jean, "The non-smooth contact dynamics
/// method", 1999). `impulse_N_s` is the start and the result; where several distributions carry a
/// shared load, the start decides which is found. False: kMostSweeps sweeps were not enough, and
/// the result is the last sweep's. Requires positive normal responses.
[[nodiscard]] bool solve_contacts(const ContactProblem& problem, NewtonMemory& memory,
                                  Eigen::VectorXd& impulse_N_s);

/// Largest error of a velocity, as a share of the fastest point's velocity or of a creep of 0.1
/// nm/s. A choice of ours.
inline constexpr double kContactTolerance = 1e-11;
inline constexpr double kNoCreep_m_s = 1e-10;
/// Largest creep of a point that breaks its law, accepted where kContactTolerance is out of reach:
/// two points of one foot in a row hold each other's slip by levers of a micrometre, and sweeps
/// only creep towards impulses that would end it. A choice of ours.
inline constexpr double kMostCreep_m_s = 1e-6;
inline constexpr int kMostSweeps = 2000;

}  // namespace torquewright::simulation
