// SPDX-License-Identifier: Apache-2.0
#include "optimization/quadratic/solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

// Equations: docs/derivations/quadratic_program.md.
namespace torquewright::optimization {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Of the greatest curvature: less counts as none, and as much below 0 as negative.
constexpr double kFlat = 1e-11;
/// Of the greatest curvature, what proximal steps add: the root of rounding, so that neither the
/// steps nor the factors lose more than half of the digits.
constexpr double kProximal = 1e-8;
constexpr int kMostProximalSteps = 200;
/// Of a step's gradient, what is still to come is rounding.
constexpr double kLeft = 1e-12;
constexpr double kNoBound = std::numeric_limits<double>::infinity();

void require_sizes(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(std::string("quadratic program: ") + what);
}

void require_program(const QuadraticProgram& program) {
  const Index n = program.slope.size(), m = program.rows.rows();
  require_sizes(program.cost.rows() == n && program.cost.cols() == n &&
                    (m == 0 || program.rows.cols() == n) && program.lower.size() == m &&
                    program.upper.size() == m,
                "sizes do not fit");
  require_sizes(program.cost.allFinite() && program.slope.allFinite() && program.rows.allFinite(),
                "a number is not finite");
  for (Index row = 0; row < m; ++row) {
    require_sizes(program.lower[row] < kNoBound && program.upper[row] > -kNoBound,
                  "a bound is no number, or an infinite one that nothing obeys");
  }
}

double size_of_bound(double bound) { return std::isfinite(bound) ? std::abs(bound) : 0.0; }

}  // namespace

std::string_view name_of(QuadraticStatus status) {
  switch (status) {
    case QuadraticStatus::kSolved:
      return "solved";
    case QuadraticStatus::kInfeasible:
      return "infeasible";
    case QuadraticStatus::kUnbounded:
      return "unbounded";
    case QuadraticStatus::kNotConvex:
      return "not convex";
    default:
      return "stalled";
  }
}

const QuadraticSolution& QuadraticSolver::solve(const QuadraticProgram& program) {
  require_program(program);
  solution_.x.setZero(program.slope.size());
  solution_.multipliers.setZero(program.rows.rows());
  solution_.direction.resize(0);
  solution_.contradicting.clear();
  solution_.contradicting.reserve(static_cast<std::size_t>(program.rows.rows()));
  solution_.steps = 0;
  if (crossed(program) || !reduce(program) || !factor(program)) return solution_;
  search(program);
  if (solution_.status == QuadraticStatus::kInfeasible) name_contradiction(program);
  answer(program);
  return solution_;
}

/// A row whose lower bound is above its upper one contradicts itself.
bool QuadraticSolver::crossed(const QuadraticProgram& program) {
  for (Index row = 0; row < program.rows.rows(); ++row) {
    if (program.lower[row] <= program.upper[row]) continue;
    solution_.status = QuadraticStatus::kInfeasible;
    solution_.contradicting.push_back(row);
    return true;
  }
  return false;
}

/// Takes the equations out: x = particular + Z y, eq. (2).
bool QuadraticSolver::reduce(const QuadraticProgram& program) {
  if (!equations_.set(program)) {
    solution_.status = QuadraticStatus::kInfeasible;
    solution_.contradicting = equations_.contradicting();
    std::sort(solution_.contradicting.begin(), solution_.contradicting.end());
    return false;
  }
  const Index rows = program.rows.rows(), room = equations_.room();
  active_set_.resize(room, rows);
  ActiveSet::Problem& reduced = active_set_.problem();
  const auto free = equations_.free();
  const VectorXd& at = equations_.particular();
  sum_.resize(rows);
  if (rows > 0) {
    reduced.rows.noalias() = program.rows * free;
    sum_.noalias() = program.rows * at;
  }
  const double reach = at.norm();
  for (Index row = 0; row < rows; ++row) {
    const double length = program.rows.row(row).norm();
    const bool is_felt = reduced.rows.row(row).norm() > kLeft * length;
    const bool is_equation = equations_.is_equation(row);
    reduced.lengths[row] = is_equation || !is_felt ? 0.0 : reduced.rows.row(row).norm();
    if (!(reduced.lengths[row] > 0.0)) reduced.rows.row(row).setZero();
    reduced.lower[row] = is_equation ? -kNoBound : program.lower[row] - sum_[row];
    reduced.upper[row] = is_equation ? kNoBound : program.upper[row] - sum_[row];
    reduced.roundings[row] = length * reach + std::max(size_of_bound(program.lower[row]),
                                                       size_of_bound(program.upper[row]));
  }
  half_.resize(program.slope.size(), room);
  half_.noalias() = program.cost * free;
  cost_.resize(room, room);
  cost_.noalias() = free.transpose() * half_;
  gradient_ = program.slope;
  gradient_.noalias() += program.cost * at;
  slope_.resize(room);
  slope_.noalias() = free.transpose() * gradient_;
  return true;
}

/// L L^T of the cost and what is added; false where a pivot is not positive.
bool QuadraticSolver::take_root(double added) {
  const Index room = cost_.rows();
  const double greatest = room > 0 ? cost_.diagonal().maxCoeff() : 0.0;
  const double least = added > 0.0 ? 0.5 * added : kFlat * greatest;
  root_ = cost_;
  root_.diagonal().array() += added;
  for (Index k = 0; k < room; ++k) {
    const double pivot = root_(k, k) - root_.row(k).head(k).squaredNorm();
    if (!(pivot > least)) return false;
    root_(k, k) = std::sqrt(pivot);
    const Index below = room - k - 1;
    auto column = root_.col(k).tail(below);
    column.noalias() -= root_.bottomLeftCorner(below, k) * root_.row(k).head(k).transpose();
    column /= root_(k, k);
  }
  return true;
}

/// J = L^-T of the cost, to which something is added where it is flat.
bool QuadraticSolver::factor(const QuadraticProgram& program) {
  const Index room = cost_.rows();
  flat_ = 0.0;
  if (!take_root(0.0)) {
    const double greatest = cost_.diagonal().cwiseAbs().maxCoeff();
    const double steepest = std::max(slope_.cwiseAbs().maxCoeff(), program.slope.norm());
    flat_ = kProximal * (greatest > 0.0 ? greatest : std::max(steepest, 1e-300));
    if (!take_root(flat_)) {
      solution_.status = QuadraticStatus::kNotConvex;
      return false;
    }
  }
  auto inverse = active_set_.problem().inverse_root.topLeftCorner(room, room);
  inverse.setIdentity();
  for (Index column = 0; column < room; ++column) {
    for (Index i = column; i >= 0; --i) {
      double rest = i == column ? 1.0 : 0.0;
      for (Index k = i + 1; k <= column; ++k) rest -= root_(k, i) * inverse(k, column);
      inverse(i, column) = rest / root_(i, i);
    }
  }
  return true;
}

/// Where nothing was added one solve; else each from the place of the last, eq. (4).
void QuadraticSolver::search(const QuadraticProgram& program) {
  const Index room = cost_.rows();
  y_.setZero(room);
  step_.setZero(room);
  ActiveSet::Problem& reduced = active_set_.problem();
  solution_.status = QuadraticStatus::kStalled;
  for (int tried = 0; tried < kMostProximalSteps; ++tried) {
    reduced.slope.head(room) = slope_ - flat_ * y_;
    const ActiveSet::End end = active_set_.solve();
    solution_.steps += active_set_.steps();
    if (end != ActiveSet::End::kSolved) {
      if (end == ActiveSet::End::kInfeasible) solution_.status = QuadraticStatus::kInfeasible;
      return;
    }
    step_ = active_set_.x() - y_;
    y_ = active_set_.x();
    const double still = flat_ * step_.norm();
    if (still <= kLeft * (slope_.norm() + cost_.norm() * y_.norm())) {
      solution_.status = QuadraticStatus::kSolved;
      return;
    }
    if (tried > 0 && falls_forever(program)) {
      solution_.status = QuadraticStatus::kUnbounded;
      return;
    }
  }
}

/// Whether the last step goes where no bound ends and the cost falls without curvature, eq. (5).
bool QuadraticSolver::falls_forever(const QuadraticProgram& program) {
  const double length = step_.norm();
  const double fall = slope_.dot(step_);
  if (!(fall < -kFlat * slope_.norm() * length)) return false;
  curve_.resize(step_.size());
  curve_.noalias() = cost_ * step_;
  if (curve_.norm() > kFlat * cost_.norm() * length) return false;
  const ActiveSet::Problem& reduced = active_set_.problem();
  for (Index row = 0; row < program.rows.rows(); ++row) {
    if (!(reduced.lengths[row] > 0.0)) continue;
    const double along = reduced.rows.row(row).dot(step_.transpose());
    const double rounding = kFlat * reduced.lengths[row] * length;
    if (std::isfinite(reduced.lower[row]) && along < -rounding) return false;
    if (std::isfinite(reduced.upper[row]) && along > rounding) return false;
  }
  solution_.direction = equations_.free() * (step_ / length);
  return true;
}

void QuadraticSolver::name_contradiction(const QuadraticProgram& program) {
  factors_.clear();
  factors_.reserve(static_cast<std::size_t>(program.rows.rows()));
  active_set_.contradiction(solution_.contradicting, factors_);
  sum_.setZero(program.slope.size());
  double size = 0.0;
  for (std::size_t i = 0; i < factors_.size(); ++i) {
    const auto row = program.rows.row(solution_.contradicting[i]);
    sum_ += factors_[i] * row.transpose();
    size += std::abs(factors_[i]) * row.norm();
  }
  equations_.add_parts_of(sum_, size, solution_.contradicting);
  std::sort(solution_.contradicting.begin(), solution_.contradicting.end());
}

void QuadraticSolver::answer(const QuadraticProgram& program) {
  solution_.x = equations_.particular();
  solution_.x.noalias() += equations_.free() * active_set_.x();
  if (solution_.status == QuadraticStatus::kInfeasible) return;
  gradient_ = program.slope;
  gradient_.noalias() += program.cost * solution_.x;
  for (std::size_t i = 0; i < active_set_.active_count(); ++i) {
    const Index row = active_set_.active_row(i);
    solution_.multipliers[row] = active_set_.multiplier(i);
    gradient_ += solution_.multipliers[row] * program.rows.row(row).transpose();
  }
  equations_.add_multipliers(gradient_, solution_.multipliers);
}

}  // namespace torquewright::optimization
