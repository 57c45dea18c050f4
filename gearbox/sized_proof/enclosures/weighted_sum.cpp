// SPDX-License-Identifier: Apache-2.0
#include "gearbox/sized_proof/enclosures/weighted_sum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace torquewright::gearbox::sized {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
/// Weights of the layers add up to 1 each; slopes cancel but for what the box's sides take up.
constexpr std::size_t kRows = 2 + kPlaces;
constexpr std::size_t kSides = 2 * kPlaces;

/// Least value of the weighted sum over the box.
double proved(const std::vector<LinearTerm>& terms, std::vector<double> weights) {
  std::array<double, 2> total{};
  for (std::size_t j = 0; j < terms.size(); ++j) {
    if (!(weights[j] > 0.0)) weights[j] = 0.0;
    if (terms[j].kind != TermKind::kCondition)
      total[static_cast<std::size_t>(terms[j].kind)] += weights[j];
  }
  const double most = std::max(total[0], total[1]) * (1.0 + 1e-14);
  const double scale = most > 1.0 ? 1.0 / most : 1.0;
  double sum = 0.0, size = 0.0;
  std::array<double, kPlaces> slope{};
  for (std::size_t j = 0; j < terms.size(); ++j) {
    if (weights[j] == 0.0) continue;
    const double weight = weights[j] * scale;
    sum += weight * terms[j].constant;
    size += weight * std::abs(terms[j].constant);
    for (std::size_t i = 0; i < kPlaces; ++i) {
      slope[i] += weight * terms[j].slope[i];
      size += weight * std::abs(terms[j].slope[i]);
    }
  }
  for (const double each : slope) sum -= std::abs(each);
  return sum - 1e-13 * size;
}

/// The dual programme: most sum of weights times constants, less what the slopes leave.
class Tableau {
 public:
  explicit Tableau(const std::vector<LinearTerm>& terms)
      : terms_(terms), columns_(terms.size() + kSides), cells_(kRows * columns_) {}

  /// False: a layer has no term.
  bool start() {
    for (const std::size_t layer : {0U, 1U}) {
      std::size_t best = columns_;
      for (std::size_t j = 0; j < terms_.size(); ++j) {
        if (static_cast<std::size_t>(terms_[j].kind) != layer) continue;
        if (best == columns_ || terms_[j].constant > terms_[best].constant) best = j;
      }
      if (best == columns_) return false;
      basis_[layer] = best;
    }
    fill();
    return true;
  }

  double value() const { return value_; }

  /// One exchange; false: nothing is gained any more. Sets the ray where there is no end.
  bool improve() {
    std::size_t entering = columns_;
    double most = 1e-12 * size_;
    for (std::size_t j = 0; j < columns_; ++j) {
      if (gain_[j] > most) {
        most = gain_[j];
        entering = j;
      }
    }
    if (entering == columns_) return false;
    std::size_t leaving = kRows;
    double least = kInfinite;
    for (std::size_t r = 0; r < kRows; ++r) {
      const double pivot = at(r, entering);
      if (!(pivot > 1e-11)) continue;
      const double steps = std::max(0.0, weight_[r]) / pivot;
      if (steps < least) {
        least = steps;
        leaving = r;
      }
    }
    if (leaving == kRows) {
      ray_.assign(terms_.size(), 0.0);
      if (entering < terms_.size()) ray_[entering] = 1.0;
      for (std::size_t r = 0; r < kRows; ++r) {
        if (basis_[r] < terms_.size()) ray_[basis_[r]] -= at(r, entering);
      }
      return false;
    }
    exchange(leaving, entering);
    return true;
  }

  std::vector<double> weights() const {
    std::vector<double> all(terms_.size(), 0.0);
    for (std::size_t r = 0; r < kRows; ++r) {
      if (basis_[r] < terms_.size()) all[basis_[r]] = weight_[r];
    }
    return all;
  }

  const std::vector<double>& ray() const { return ray_; }

 private:
  double& at(std::size_t row, std::size_t column) { return cells_[row * columns_ + column]; }
  double cost(std::size_t column) const {
    return column < terms_.size() ? terms_[column].constant : -1.0;
  }

  /// The first basis: a term of each layer, and the sides that take up their slopes.
  void fill() {
    std::array<double, kRows> right{1.0, 1.0};
    for (std::size_t j = 0; j < terms_.size(); ++j) {
      if (terms_[j].kind != TermKind::kCondition) {
        at(static_cast<std::size_t>(terms_[j].kind), j) = 1.0;
      }
      for (std::size_t i = 0; i < kPlaces; ++i) at(2 + i, j) = terms_[j].slope[i];
    }
    for (std::size_t i = 0; i < kPlaces; ++i) {
      at(2 + i, terms_.size() + 2 * i) = 1.0;
      at(2 + i, terms_.size() + 2 * i + 1) = -1.0;
    }
    for (std::size_t i = 0; i < kPlaces; ++i) {
      for (const std::size_t layer : {0U, 1U}) {
        const double factor = at(2 + i, basis_[layer]);
        if (factor == 0.0) continue;
        for (std::size_t j = 0; j < columns_; ++j) at(2 + i, j) -= factor * at(layer, j);
        right[2 + i] -= factor * right[layer];
      }
      const bool is_negative = right[2 + i] < 0.0;
      basis_[2 + i] = terms_.size() + 2 * i + (is_negative ? 1 : 0);
      if (!is_negative) continue;
      for (std::size_t j = 0; j < columns_; ++j) at(2 + i, j) = -at(2 + i, j);
      right[2 + i] = -right[2 + i];
    }
    weight_ = right;
    gain_.assign(columns_, 0.0);
    value_ = 0.0;
    for (std::size_t r = 0; r < kRows; ++r) value_ += cost(basis_[r]) * weight_[r];
    for (std::size_t j = 0; j < columns_; ++j) {
      gain_[j] = cost(j);
      for (std::size_t r = 0; r < kRows; ++r) gain_[j] -= cost(basis_[r]) * at(r, j);
      size_ = std::max(size_, std::abs(cost(j)));
    }
  }

  void exchange(std::size_t leaving, std::size_t entering) {
    const double pivot = at(leaving, entering);
    double* const row = &cells_[leaving * columns_];
    for (std::size_t j = 0; j < columns_; ++j) row[j] /= pivot;
    weight_[leaving] /= pivot;
    for (std::size_t r = 0; r < kRows; ++r) {
      const double factor = r == leaving ? 0.0 : at(r, entering);
      if (factor == 0.0) continue;
      double* const other = &cells_[r * columns_];
      for (std::size_t j = 0; j < columns_; ++j) other[j] -= factor * row[j];
      weight_[r] -= factor * weight_[leaving];
    }
    const double gain = gain_[entering];
    for (std::size_t j = 0; j < columns_; ++j) gain_[j] -= gain * row[j];
    value_ += gain * weight_[leaving];
    basis_[leaving] = entering;
  }

  const std::vector<LinearTerm>& terms_;
  std::size_t columns_;
  std::vector<double> cells_;
  std::array<std::size_t, kRows> basis_{};
  std::array<double, kRows> weight_{};
  std::vector<double> gain_;
  std::vector<double> ray_;
  double value_ = 0.0, size_ = 1e-300;
};

}  // namespace

WeightedProof weigh(const std::vector<LinearTerm>& terms, double enough) {
  Tableau tableau(terms);
  if (!tableau.start()) return {};
  constexpr int kMostExchanges = 60;
  for (int i = 0; i < kMostExchanges; ++i) {
    if (tableau.value() > enough * (1.0 + 1e-9) && tableau.value() > 0.0) break;
    if (!tableau.improve()) break;
  }
  if (!tableau.ray().empty() && proved(terms, tableau.ray()) > 0.0) return {kInfinite};
  return {std::max(0.0, proved(terms, tableau.weights()))};
}

}  // namespace torquewright::gearbox::sized
