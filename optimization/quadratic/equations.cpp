// SPDX-License-Identifier: Apache-2.0
#include "optimization/quadratic/equations.hpp"

#include <Eigen/Householder>
#include <algorithm>
#include <cmath>

namespace torquewright::optimization {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// What rounding leaves, over the numbers' own size, of a row that others make up.
constexpr double kMadeUp = 1e-10;
/// Of a sum of other rows, what their factors' rounding makes of equations that have no part in it.
constexpr double kNoPartOf = 1e-6;

}  // namespace

bool EquationSpace::set(const QuadraticProgram& program) {
  contradicting_.clear();
  gather(program);
  factor();
  form_basis();
  return place(program);
}

void EquationSpace::gather(const QuadraticProgram& program) {
  const Index n = program.slope.size();
  const Index rows = program.rows.rows();
  equations_.clear();
  equations_.reserve(static_cast<std::size_t>(rows));
  contradicting_.reserve(static_cast<std::size_t>(rows));
  place_of_.assign(static_cast<std::size_t>(rows), -1);
  for (Index row = 0; row < rows; ++row) {
    if (program.lower[row] != program.upper[row]) continue;
    place_of_[static_cast<std::size_t>(row)] = static_cast<Index>(equations_.size());
    equations_.push_back(row);
  }
  const auto count = static_cast<Index>(equations_.size());
  columns_.resize(n, count);
  lengths_.resize(count);
  scales_.resize(std::min(n, count));
  parts_.resize(std::max(n, count));
  workspace_.resize(std::max(n, count));
  basis_.resize(n, n);
  particular_.resize(n);
  for (Index i = 0; i < count; ++i) {
    const auto row = program.rows.row(equations_[static_cast<std::size_t>(i)]);
    lengths_[i] = row.norm();
    if (lengths_[i] > 0.0) {
      columns_.col(i) = row.transpose() / lengths_[i];
    } else {
      columns_.col(i).setZero();
    }
  }
}

/// A P = Q R: the column whose remainder is longest comes next.
void EquationSpace::factor() {
  const Index n = columns_.rows(), count = columns_.cols();
  rank_ = 0;
  for (; rank_ < std::min(n, count); ++rank_) {
    Index longest = rank_;
    double most = 0.0;
    for (Index column = rank_; column < count; ++column) {
      const double remainder = columns_.col(column).tail(n - rank_).squaredNorm();
      if (remainder > most) {
        most = remainder;
        longest = column;
      }
    }
    if (std::sqrt(most) <= kMadeUp) return;
    columns_.col(rank_).swap(columns_.col(longest));
    std::swap(lengths_[rank_], lengths_[longest]);
    std::swap(equations_[static_cast<std::size_t>(rank_)],
              equations_[static_cast<std::size_t>(longest)]);
    double beta = 0.0;
    columns_.col(rank_).tail(n - rank_).makeHouseholderInPlace(scales_[rank_], beta);
    columns_(rank_, rank_) = beta;
    columns_.bottomRightCorner(n - rank_, count - rank_ - 1)
        .applyHouseholderOnTheLeft(columns_.col(rank_).tail(n - rank_ - 1), scales_[rank_],
                                   workspace_.data());
  }
}

void EquationSpace::form_basis() {
  const Index n = columns_.rows();
  basis_.setIdentity();
  for (Index k = rank_ - 1; k >= 0; --k) {
    basis_.bottomRightCorner(n - k, n - k)
        .applyHouseholderOnTheLeft(columns_.col(k).tail(n - k - 1), scales_[k], workspace_.data());
  }
}

/// The shortest x of the equations that are not made up of others, and whether it obeys the rest.
bool EquationSpace::place(const QuadraticProgram& program) {
  for (Index i = 0; i < rank_; ++i) {
    double rest = program.lower[equations_[static_cast<std::size_t>(i)]] / lengths_[i];
    for (Index k = 0; k < i; ++k) rest -= columns_(k, i) * parts_[k];
    parts_[i] = rest / columns_(i, i);
  }
  particular_.noalias() = basis_.leftCols(rank_) * parts_.head(rank_);
  for (Index i = rank_; i < columns_.cols(); ++i) {
    const Index row = equations_[static_cast<std::size_t>(i)];
    const double wanted = program.lower[row];
    const double off = std::abs(program.rows.row(row).dot(particular_) - wanted);
    if (off <= kMadeUp * (lengths_[i] * particular_.norm() + std::abs(wanted))) continue;
    contradicting_.push_back(row);
    parts_.head(rank_) = columns_.col(i).head(rank_);
    solve_upper(rank_);
    for (Index k = 0; k < rank_; ++k) {
      if (std::abs(parts_[k]) > kMadeUp) {
        contradicting_.push_back(equations_[static_cast<std::size_t>(k)]);
      }
    }
    return false;
  }
  return true;
}

/// R c = parts, in place.
void EquationSpace::solve_upper(Index rank) {
  for (Index i = rank - 1; i >= 0; --i) {
    for (Index k = i + 1; k < rank; ++k) parts_[i] -= columns_(i, k) * parts_[k];
    parts_[i] /= columns_(i, i);
  }
}

void EquationSpace::add_multipliers(const VectorXd& gradient, VectorXd& multipliers) {
  parts_.head(rank_).noalias() = -basis_.leftCols(rank_).transpose() * gradient;
  solve_upper(rank_);
  for (Index i = 0; i < rank_; ++i) {
    multipliers[equations_[static_cast<std::size_t>(i)]] += parts_[i] / lengths_[i];
  }
}

void EquationSpace::add_parts_of(const VectorXd& sum, double size, std::vector<Index>& rows) {
  parts_.head(rank_).noalias() = basis_.leftCols(rank_).transpose() * sum;
  solve_upper(rank_);
  for (Index i = 0; i < rank_; ++i) {
    if (std::abs(parts_[i]) > kNoPartOf * size) {
      rows.push_back(equations_[static_cast<std::size_t>(i)]);
    }
  }
}

}  // namespace torquewright::optimization
