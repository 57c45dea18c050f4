// SPDX-License-Identifier: Apache-2.0
#include "optimization/quadratic/active_set.hpp"

#include <Eigen/Jacobi>
#include <algorithm>
#include <cmath>
#include <limits>

namespace torquewright::optimization {
namespace {

using Eigen::Index;

/// What rounding leaves of a bound that holds, over the numbers' own size.
constexpr double kHolds = 1e-9;
/// Of a row's length in J, what remains of one that the active rows make up.
constexpr double kDependent = 1e-10;
/// Of the greatest factor of a contradiction, what rounding makes of rows that have no part in it.
constexpr double kNoPart = 1e-6;
constexpr double kNoLimit = std::numeric_limits<double>::infinity();

Index count_of(const auto& list) { return static_cast<Index>(list.size()); }

}  // namespace

void ActiveSet::resize(Index unknowns, Index rows) {
  if (rows != rows_) active_.clear();
  unknowns_ = unknowns;
  rows_ = rows;
  if (basis_.rows() < unknowns) {
    for (Eigen::MatrixXd* square : {&basis_, &factor_, &problem_.inverse_root}) {
      square->resize(unknowns, unknowns);
    }
    for (Eigen::VectorXd* column : {&x_, &multipliers_, &turned_, &answer_, &normal_}) {
      column->resize(unknowns + 1);
    }
    problem_.slope.resize(unknowns);
  }
  problem_.rows.resize(rows, unknowns);
  for (Eigen::VectorXd* column :
       {&problem_.lower, &problem_.upper, &problem_.lengths, &problem_.roundings}) {
    column->resize(rows);
  }
  active_.reserve(static_cast<std::size_t>(basis_.rows()) + 1);
  before_.reserve(static_cast<std::size_t>(basis_.rows()) + 1);
}

ActiveSet::End ActiveSet::solve() {
  begin();
  const int most_steps = steps_ + 100 + 10 * static_cast<int>(unknowns_ + rows_);
  while (steps_ < most_steps) {
    minimise();
    const Bound next = most_violated();
    if (next.row < 0) return End::kSolved;
    const End end = enter(next);
    if (end != End::kSolved) return end;
  }
  return End::kStalled;
}

/// The minimum under the bounds that were active last, less those whose multiplier has the wrong
/// sign there: a minimum of fewer bounds, from which the method may begin.
void ActiveSet::begin() {
  steps_ = 0;
  basis_.topLeftCorner(unknowns_, unknowns_) =
      problem_.inverse_root.topLeftCorner(unknowns_, unknowns_);
  std::swap(before_, active_);
  active_.clear();
  for (const Bound& bound : before_) {
    if (count_of(active_) == unknowns_) break;
    if (!std::isfinite(bound_of(bound)) || !(problem_.lengths[bound.row] > 0.0)) continue;
    turn(bound);
    add(bound);
  }
  while (!active_.empty()) {
    minimise();
    Index least = 0;
    if (multipliers_.head(count_of(active_)).minCoeff(&least) >= 0.0) return;
    drop(least);
    ++steps_;
  }
}

double ActiveSet::bound_of(const Bound& bound) const {
  return bound.side > 0.0 ? problem_.lower[bound.row] : -problem_.upper[bound.row];
}

/// d = J^T n of the bound's row, turned so that it is bounded below.
void ActiveSet::turn(const Bound& bound) {
  normal_.head(unknowns_) = bound.side * problem_.rows.row(bound.row).head(unknowns_).transpose();
  turned_.head(unknowns_).noalias() =
      basis_.topLeftCorner(unknowns_, unknowns_).transpose() * normal_.head(unknowns_);
}

/// Of the row that was turned last. False where the active ones make it up.
bool ActiveSet::add(const Bound& bound) {
  const Index place = count_of(active_);
  const double remainder = turned_.segment(place, unknowns_ - place).norm();
  if (!(remainder > kDependent * turned_.head(unknowns_).norm())) return false;
  Eigen::JacobiRotation<double> rotation;
  for (Index j = unknowns_ - 1; j > place; --j) {
    double length = 0.0;
    rotation.makeGivens(turned_[j - 1], turned_[j], &length);
    turned_[j - 1] = length;
    turned_[j] = 0.0;
    basis_.topRows(unknowns_).applyOnTheRight(j - 1, j, rotation);
  }
  factor_.col(place).head(place + 1) = turned_.head(place + 1);
  active_.push_back(bound);
  return true;
}

void ActiveSet::drop(Index place) {
  const Index last = count_of(active_) - 1;
  Eigen::JacobiRotation<double> rotation;
  for (Index j = place; j < last; ++j) {
    factor_.col(j).head(j + 2) = factor_.col(j + 1).head(j + 2);
    multipliers_[j] = multipliers_[j + 1];
  }
  for (Index j = place; j < last; ++j) {
    double length = 0.0;
    rotation.makeGivens(factor_(j, j), factor_(j + 1, j), &length);
    factor_(j, j) = length;
    factor_(j + 1, j) = 0.0;
    for (Index k = j + 1; k < last; ++k) {
      const double upper = factor_(j, k), lower = factor_(j + 1, k);
      factor_(j, k) = rotation.c() * upper - rotation.s() * lower;
      factor_(j + 1, k) = rotation.s() * upper + rotation.c() * lower;
    }
    basis_.topRows(unknowns_).applyOnTheRight(j, j + 1, rotation);
  }
  active_.erase(active_.begin() + place);
}

/// The minimum under the active bounds: with x = J v and J^T N = [R; 0] it is R^T v1 = b,
/// v2 = -J2^T slope, and R u = v1 + J1^T slope.
void ActiveSet::minimise() {
  const Index active = count_of(active_);
  auto v = turned_.head(unknowns_);
  answer_.head(unknowns_).noalias() =
      basis_.topLeftCorner(unknowns_, unknowns_).transpose() * problem_.slope.head(unknowns_);
  v = -answer_.head(unknowns_);
  for (Index i = 0; i < active; ++i) {
    double rest = bound_of(active_[static_cast<std::size_t>(i)]);
    for (Index k = 0; k < i; ++k) rest -= factor_(k, i) * v[k];
    v[i] = rest / factor_(i, i);
  }
  for (Index i = active - 1; i >= 0; --i) {
    double rest = v[i] + answer_[i];
    for (Index k = i + 1; k < active; ++k) rest -= factor_(i, k) * multipliers_[k];
    multipliers_[i] = rest / factor_(i, i);
  }
  x_.head(unknowns_).noalias() = basis_.topLeftCorner(unknowns_, unknowns_) * v;
}

/// The bound that is violated by the greatest distance; row -1 where all hold.
ActiveSet::Bound ActiveSet::most_violated() const {
  const double reach = x_.head(unknowns_).norm();
  Bound worst{-1, 0.0};
  double most = 0.0;
  for (Index row = 0; row < rows_; ++row) {
    const double value = problem_.rows.row(row).head(unknowns_).dot(x_.head(unknowns_).transpose());
    const double below = problem_.lower[row] - value, above = value - problem_.upper[row];
    const double off = std::max(below, above);
    if (!(off > kHolds * (problem_.lengths[row] * reach + problem_.roundings[row]))) continue;
    const double distance = problem_.lengths[row] > 0.0 ? off / problem_.lengths[row] : kNoLimit;
    if (distance > most) {
      most = distance;
      worst = {row, below > above ? 1.0 : -1.0};
    }
  }
  return worst;
}

/// Makes a violated bound active, by steps that drop those which stand in the way.
ActiveSet::End ActiveSet::enter(const Bound& bound) {
  double price = 0.0;
  while (true) {
    ++steps_;
    turn(bound);
    const Index active = count_of(active_);
    for (Index i = active - 1; i >= 0; --i) {  // answer = R^-1 d1
      double rest = turned_[i];
      for (Index k = i + 1; k < active; ++k) rest -= factor_(i, k) * answer_[k];
      answer_[i] = rest / factor_(i, i);
    }
    double dual = kNoLimit;
    Index blocking = -1;
    const double size = turned_.head(unknowns_).norm();
    for (Index i = 0; i < active; ++i) {
      if (!(answer_[i] > kDependent)) continue;
      const double length = std::max(0.0, multipliers_[i]) / answer_[i];
      if (length < dual) {
        dual = length;
        blocking = i;
      }
    }
    const auto free = turned_.segment(active, unknowns_ - active);
    const double slope = free.squaredNorm();
    const bool moves = slope > kDependent * kDependent * size * size;
    if (!moves && blocking < 0) {
      contradicted_ = bound;
      return End::kInfeasible;
    }
    const double lacking = bound_of(bound) - normal_.head(unknowns_).dot(x_.head(unknowns_));
    const double full = moves ? lacking / slope : kNoLimit;
    const double step = std::min(dual, full);
    multipliers_.head(active) -= step * answer_.head(active);
    price += step;
    if (moves) {
      x_.head(unknowns_).noalias() +=
          step * (basis_.block(0, active, unknowns_, unknowns_ - active) * free);
    }
    if (full <= dual) {
      multipliers_[active] = price;
      return add(bound) ? End::kSolved : End::kStalled;
    }
    drop(blocking);
  }
}

void ActiveSet::contradiction(std::vector<Index>& rows, std::vector<double>& factors) const {
  rows.push_back(contradicted_.row);
  factors.push_back(contradicted_.side);
  const double greatest = answer_.head(count_of(active_)).lpNorm<Eigen::Infinity>();
  for (std::size_t i = 0; i < active_.size(); ++i) {
    const double factor = answer_[static_cast<Index>(i)];
    if (!(std::abs(factor) > kNoPart * greatest)) continue;
    rows.push_back(active_[i].row);
    factors.push_back(-factor * active_[i].side);
  }
}

}  // namespace torquewright::optimization
