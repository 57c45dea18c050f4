// SPDX-License-Identifier: Apache-2.0
// Oracle: Coulomb's law itself (docs/derivations/time_stepping.md eq. (4)), point by point.
#include "simulation/contact/contact_impulses.hpp"

#include <gtest/gtest.h>

namespace torquewright::simulation {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// How far a solution is from the law: of velocities in m/s, of impulses over the friction cone in
/// N s, and of work that friction would do.
double off(const ContactProblem& problem, const VectorXd& impulse_N_s) {
  const VectorXd u = problem.response_1_kg * impulse_N_s + problem.free_m_s;
  double worst = 0.0;
  for (Index k = 0; k < problem.friction_coefficients.size(); ++k) {
    const Vector2d p_t = impulse_N_s.segment<2>(3 * k), u_t = u.segment<2>(3 * k);
    const double p_n = impulse_N_s[3 * k + 2], u_n = u[3 * k + 2];
    const double most = problem.friction_coefficients[k] * p_n;
    worst = std::max({worst, -p_n, -u_n, std::min(p_n, u_n), p_t.norm() - most});
    // Sticks, or slides against the greatest friction: p_t = -most u_t/|u_t|.
    const double slides = (most * u_t + u_t.norm() * p_t).norm() / std::max(most, 1e-12);
    worst = std::max(worst, std::min(u_t.norm(), slides));
  }
  return worst;
}

// Two toes of the hopper on its step, as trial 10 of seed 1 had them: whole sweeps go round in a
// circle of 0.7 to 9 mm/s.
TEST(ContactImpulses, AreFoundWhereWholeSweepsGoRoundInACircle) {
  ContactProblem problem;
  problem.response_1_kg.resize(6, 6);
  problem.response_1_kg << 1.4888844301172719, 0.14247871912639981, 0.31357562723757515,
      1.138027685266259, 0.1667557035525295, 0.10276471893190417,  //
      0.14247871912639981, 1.0641985023501803, 0.25020041666683246, -0.26098070849674038,
      1.0921154612255313, -0.24534724804733446,  //
      0.31357562723757515, 0.25020041666683246, 0.24012151731762871, 0.091277798497591878,
      0.26558203478123954, 0.027199956114895729,  //
      1.138027685266259, -0.26098070849674038, 0.091277798497591878, 1.2040374310601478,
      -0.26554827129537451, 0.27472295920254619,  //
      0.1667557035525295, 1.0921154612255313, 0.26558203478123954, -0.26554827129537451,
      1.1220282819014604, -0.25724572793370321,  //
      0.10276471893190417, -0.24534724804733446, 0.027199956114895729, 0.27472295920254619,
      -0.25724572793370321, 0.24650726004301288;
  problem.free_m_s.resize(6);
  problem.free_m_s << 0.0064169136860777985, 0.00082199869732213168, -0.00061908173272869971,
      -0.0633019096935582, 0.0056460497190021011, -0.0022149846276628732;
  problem.friction_coefficients = VectorXd::Constant(2, 0.75268734161774353);
  VectorXd impulse_N_s(6);
  impulse_N_s << -0.0056508393752758351, 0.00056450984895663019, 0.0075449205512370309,
      0.0045113136046274491, -0.00030079815599941772, 0.0060069172192174841;
  NewtonMemory memory;
  ASSERT_TRUE(solve_contacts(problem, memory, impulse_N_s));
  EXPECT_LT(off(problem, impulse_N_s), 2.0 * kMostCreep_m_s);
}

}  // namespace
}  // namespace torquewright::simulation
