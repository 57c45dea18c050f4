// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/contact/contact_problem.hpp"

namespace torquewright::simulation {

/// Impulses with which each point obeys the law of coulomb_impulse_N_s() while all others act, by
/// sweeps over the points (nonsmooth Gauss-Seidel: Jean, "The non-smooth contact dynamics method",
/// 1999). `impulse_N_s` is where to begin from, and the result; where points share a load that more
/// than one distribution carries, it decides which is found. False: kMostSweeps did not do; the
/// result is the last sweep's. Requires normal responses above zero.
[[nodiscard]] bool solve_contacts(const ContactProblem& problem, Eigen::VectorXd& impulse_N_s);

/// No velocity is off by more than this share of the fastest, or than a point creeps by a tenth of
/// a nanometre in a second.
inline constexpr double kContactTolerance = 1e-11;
inline constexpr double kNoCreep_m_s = 1e-10;
/// Where that is not to be had: two points of one foot in a row hold each other's slip by levers of
/// a micrometre, and sweeps creep towards impulses that would end it. So far any point may break
/// its law then: a micrometre in a second.
inline constexpr double kMostCreep_m_s = 1e-6;
inline constexpr int kMostSweeps = 2000;

}  // namespace torquewright::simulation
