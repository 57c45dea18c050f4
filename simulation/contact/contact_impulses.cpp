// SPDX-License-Identifier: Apache-2.0
#include "simulation/contact/contact_impulses.hpp"

#include <algorithm>

#include "simulation/contact/coulomb.hpp"

namespace torquewright::simulation {
namespace {

using Eigen::Index;

/// Sweeps find out which points press, stick and slide; Newton's steps do the rest.
constexpr int kSweepsBeforeNewton = 2;
constexpr int kSweepsBetweenNewton = 10;
/// After so many a creep that nobody sees is taken for rest.
constexpr int kPatientSweeps = 200;
/// From then on sweeps go half as far: where one point is about to slide while another slides whole
/// ones may go round in a circle.
constexpr double kShortened = 0.5;

/// One point while the others' impulses stand.
PointResponse alone(const ContactProblem& problem, const Eigen::VectorXd& impulse_N_s, Index k) {
  PointResponse point;
  point.response_1_kg = problem.response_1_kg.block<3, 3>(3 * k, 3 * k);
  point.free_m_s = problem.free_m_s.segment<3>(3 * k) +
                   problem.response_1_kg.middleRows<3>(3 * k) * impulse_N_s -
                   point.response_1_kg * impulse_N_s.segment<3>(3 * k);
  point.friction_coefficient = problem.friction_coefficients[k];
  return point;
}

}  // namespace

bool solve_contacts(const ContactProblem& problem, NewtonMemory& memory,
                    Eigen::VectorXd& impulse_N_s) {
  const Index points = problem.friction_coefficients.size();
  const double tolerance_m_s =
      std::max(kContactTolerance * problem.free_m_s.cwiseAbs().maxCoeff(), kNoCreep_m_s);
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    double change_m_s = 0.0;
    for (Index k = 0; k < points; ++k) {
      const PointResponse point = alone(problem, impulse_N_s, k);
      const Eigen::Vector3d impulse = coulomb_impulse_N_s(point);
      const Eigen::Vector3d change = impulse - impulse_N_s.segment<3>(3 * k);
      change_m_s = std::max(change_m_s, (point.response_1_kg * change).cwiseAbs().maxCoeff());
      if (sweep < kPatientSweeps) {
        impulse_N_s.segment<3>(3 * k) = impulse;
      } else {
        impulse_N_s.segment<3>(3 * k) += kShortened * change;
      }
    }
    if (change_m_s <= tolerance_m_s) return true;
    if (sweep >= kPatientSweeps && change_m_s <= kMostCreep_m_s) return true;
    const bool is_creeping = (sweep + 1) % kSweepsBetweenNewton == kSweepsBeforeNewton;
    if (is_creeping && points > 1 && newton_contacts(problem, tolerance_m_s, memory, impulse_N_s))
      return true;
  }
  return false;
}

}  // namespace torquewright::simulation
