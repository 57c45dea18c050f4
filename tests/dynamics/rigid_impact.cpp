// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/impact.md.
#include "tests/dynamics/rigid_impact.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "dynamics/mass_matrix.hpp"
#include "tests/dynamics/contact_law.hpp"

namespace torquewright::test {
namespace {

using dynamics::TreeState;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kStill = 1e-12;  // change of an impulse in a sweep, of the largest one
constexpr double kDead = 1e-14;
constexpr int kMaxSweeps = 20000;
constexpr double kUnit = 1e-9;

void require_contact(const TreeState& state, const Contact& contact) {
  if (contact.point.body >= state.tree().bodies.size() || !contact.point.p_B_m.allFinite()) {
    throw std::invalid_argument("contact: no such point");
  }
  if (!(std::abs(contact.normal.norm() - 1) <= kUnit)) {
    throw std::invalid_argument("contact: the normal is not a unit vector");
  }
  if (!(contact.friction_coefficient >= 0) || !std::isfinite(contact.friction_coefficient)) {
    throw std::invalid_argument("contact: the friction coefficient is negative or not finite");
  }
  if (!(contact.restitution >= 0 && contact.restitution <= 1)) {
    throw std::invalid_argument("contact: the restitution is outside [0, 1]");
  }
}

/// Columns: two tangents and the normal.
Matrix3d axes_of(const Vector3d& normal) {
  Matrix3d axes;
  axes.col(0) = normal.unitOrthogonal();
  axes.col(1) = normal.cross(axes.col(0));
  axes.col(2) = normal;
  return axes;
}

/// All contacts, stacked, three rows each in their own axes.
struct Problem {
  std::vector<Matrix3d> axes;
  MatrixXd jacobian;  // (3 contacts x velocities)
  MatrixXd mobility;  // J M^-1 J^T
  VectorXd before;    // v-
  VectorXd impulses;
};

Problem problem_of(const TreeState& state, std::span<const Contact> contacts) {
  const auto rows = 3 * static_cast<Eigen::Index>(contacts.size());
  Problem problem{{}, MatrixXd(rows, state.velocity().size()), {}, {}, VectorXd::Zero(rows)};
  Eigen::Matrix<double, 3, Eigen::Dynamic> one(3, state.velocity().size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    require_contact(state, contacts[i]);
    problem.axes.push_back(axes_of(contacts[i].normal));
    point_jacobian(state, contacts[i].point, one);
    problem.jacobian.middleRows<3>(3 * static_cast<Eigen::Index>(i)) =
        problem.axes.back().transpose() * one;
  }
  problem.before = problem.jacobian * state.velocity();
  return problem;
}

/// One contact after the other takes what is right for it as the others stand; eq. (7). The largest
/// change.
double sweep(std::span<const Contact> contacts, Problem& problem) {
  double change_N_s = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto row = 3 * static_cast<Eigen::Index>(i);
    const Vector3d own = problem.impulses.segment<3>(row);
    LocalContact local;
    local.mobility = problem.mobility.block<3, 3>(row, row);
    local.friction_coefficient = contacts[i].friction_coefficient;
    local.velocity = problem.before.segment<3>(row) +
                     problem.mobility.middleRows<3>(row) * problem.impulses - local.mobility * own;
    local.velocity.z() += contacts[i].restitution * std::min(0.0, problem.before[row + 2]);
    const Vector3d next = impulse_N_s(local);
    change_N_s = std::max(change_N_s, (next - own).cwiseAbs().maxCoeff());
    problem.impulses.segment<3>(row) = next;
  }
  return change_N_s;
}

/// Directions in which no impulse moves anything (a planar robot's side, a point on its own axis)
/// stand still: a heavy partner there keeps blocks of the mobility invertible.
void fill_dead_directions(MatrixXd& mobility) {
  for (Eigen::Index row = 0; row < mobility.rows(); row += 3) {
    auto block = mobility.block<3, 3>(row, row);
    block.diagonal().array() += kDead * std::max(block.trace(), 1e-300);
  }
}

}  // namespace

Impact impact(TreeState& state, std::span<const Contact> contacts) {
  Problem problem = problem_of(state, contacts);
  const Eigen::Index size = state.velocity().size();
  MatrixXd mass(size, size);
  mass_matrix(state, mass);
  const Eigen::LLT<MatrixXd> factors(mass);
  Impact result;
  if (factors.info() != Eigen::Success) return result;
  MatrixXd answer(size, problem.jacobian.rows());  // M^-1 J^T
  if (!contacts.empty()) answer = factors.solve(problem.jacobian.transpose());
  problem.mobility = problem.jacobian * answer;
  fill_dead_directions(problem.mobility);
  result.status = ImpactStatus::kNotConverged;
  while (result.status == ImpactStatus::kNotConverged && result.sweeps < kMaxSweeps) {
    const double change_N_s = sweep(contacts, problem);
    ++result.sweeps;
    const double scale_N_s = contacts.empty() ? 0 : problem.impulses.cwiseAbs().maxCoeff();
    if (change_N_s <= kStill * scale_N_s) result.status = ImpactStatus::kSolved;
  }
  const VectorXd jump = answer * problem.impulses;
  result.velocity = state.velocity() + jump;
  result.generalized_impulse = problem.jacobian.transpose() * problem.impulses;
  result.lost_energy_J = -result.generalized_impulse.dot(state.velocity() + 0.5 * jump);  // eq. (8)
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    result.impulses_N_s.emplace_back(problem.axes[i] *
                                     problem.impulses.segment<3>(3 * static_cast<Eigen::Index>(i)));
  }
  return result;
}

}  // namespace torquewright::test
