// SPDX-License-Identifier: Apache-2.0
#include "identification/model.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "identification/tight_spots.hpp"

namespace torquewright::identification {
namespace {

/// Of the smallest to the largest pivot, columns scaled to unit length: below it they are the same.
constexpr double kDependent = 1e-6;
/// The same where only an error is asked for, which says itself how badly a value is known.
constexpr double kSingular = 1e-11;

/// The products of a few combinations of columns, and of the target, in each block.
struct Reduced {
  std::vector<Eigen::MatrixXd> blocks;
};

/// Columns that occur in the coefficients, and the matrix that combines them.
struct Columns {
  std::vector<Eigen::Index> columns;
  Eigen::MatrixXd weights;  ///< (columns + 1) x (coefficients + 1): the target goes along.
};

Columns select(const std::vector<Coefficient>& coefficients, Eigen::Index target) {
  Columns selection;
  for (const Coefficient& coefficient : coefficients) {
    for (const auto& term : coefficient.terms) {
      selection.columns.push_back(static_cast<Eigen::Index>(term.column));
    }
  }
  std::sort(selection.columns.begin(), selection.columns.end());
  selection.columns.erase(std::unique(selection.columns.begin(), selection.columns.end()),
                          selection.columns.end());
  const auto k = static_cast<Eigen::Index>(coefficients.size());
  const auto many = static_cast<Eigen::Index>(selection.columns.size());
  selection.weights = Eigen::MatrixXd::Zero(many + 1, k + 1);
  for (Eigen::Index j = 0; j < k; ++j) {
    for (const auto& term : coefficients[static_cast<std::size_t>(j)].terms) {
      const auto at = std::lower_bound(selection.columns.begin(), selection.columns.end(),
                                       static_cast<Eigen::Index>(term.column));
      selection.weights(at - selection.columns.begin(), j) += term.weight;
    }
  }
  selection.weights(many, k) = 1.0;
  selection.columns.push_back(target);
  return selection;
}

Eigen::MatrixXd reduced(const Eigen::MatrixXd& product, const Columns& selection) {
  const Eigen::MatrixXd part = product(selection.columns, selection.columns);
  return selection.weights.transpose() * part * selection.weights;
}

/// Solves the scaled normal equations; empty where columns depend on one another.
Eigen::VectorXd solved(const Eigen::MatrixXd& product, double least_pivot = kDependent) {
  const Eigen::Index k = product.rows() - 1;
  if (k == 0) return Eigen::VectorXd(0);
  Eigen::VectorXd scale(k);
  for (Eigen::Index j = 0; j < k; ++j) {
    if (!(product(j, j) > 0.0)) return {};
    scale[j] = 1.0 / std::sqrt(product(j, j));
  }
  const Eigen::MatrixXd matrix =
      scale.asDiagonal() * product.topLeftCorner(k, k) * scale.asDiagonal();
  const Eigen::LDLT<Eigen::MatrixXd> factors(matrix);
  if (factors.info() != Eigen::Success || factors.vectorD().minCoeff() < least_pivot) return {};
  const Eigen::VectorXd right = scale.asDiagonal() * product.col(k).head(k);
  return scale.asDiagonal() * factors.solve(right);
}

bool within_limits(const std::vector<Coefficient>& coefficients, const Eigen::VectorXd& values) {
  for (std::size_t j = 0; j < coefficients.size(); ++j) {
    const double value = values[static_cast<Eigen::Index>(j)];
    if (!std::isfinite(value) || value < coefficients[j].lowest ||
        value > coefficients[j].highest) {
      return false;
    }
  }
  return true;
}

/// Values with the target's -1 behind.
Eigen::VectorXd with_target(const Eigen::VectorXd& values) {
  Eigen::VectorXd vector(values.size() + 1);
  vector << values, -1.0;
  return vector;
}

/// Covariance of fitted values by the scatter of the blocks' scores (White's estimate, by block, so
/// that correlation within blocks does not matter).
Eigen::MatrixXd sandwich(const std::vector<Eigen::MatrixXd>& blocks, const Eigen::MatrixXd& total,
                         const Eigen::VectorXd& values) {
  const Eigen::Index k = values.size();
  if (k == 0) return Eigen::MatrixXd(0, 0);
  const Eigen::VectorXd vector = with_target(values);
  Eigen::MatrixXd scores = Eigen::MatrixXd::Zero(k, k);
  for (const Eigen::MatrixXd& block : blocks) {
    if (block.size() == 0) continue;
    const Eigen::VectorXd score = (block * vector).head(k);
    scores += score * score.transpose();
  }
  const Eigen::MatrixXd inverse = total.topLeftCorner(k, k).inverse();
  return inverse * scores * inverse.transpose();
}

}  // namespace

std::size_t Fit::first_of_member(const Dictionary& dictionary, std::size_t member,
                                 std::size_t always) const {
  std::size_t first = always;
  for (std::size_t m = 0; m < member; ++m) {
    first += dictionary.variants[members[m]].coefficients.size();
  }
  return first;
}

Fitter::Fitter(const Gram& gram, const Dictionary& dictionary, std::vector<std::size_t> folds,
               std::vector<Coefficient> always)
    : gram_(gram), dictionary_(dictionary), folds_(std::move(folds)), always_(std::move(always)) {
  for (const std::size_t fold : folds_) {
    if (fold != kNoFold) fold_count_ = std::max(fold_count_, fold + 1);
  }
}

std::vector<Coefficient> Fitter::coefficients_of(const Members& members) const {
  std::vector<Coefficient> coefficients = always_;
  for (const std::size_t member : members) {
    const auto& own = dictionary_.variants[member].coefficients;
    coefficients.insert(coefficients.end(), own.begin(), own.end());
  }
  return coefficients;
}

Coefficient Fitter::warmed_friction(const Coefficient& like, const Fit& cold) const {
  Coefficient coefficient = like;
  coefficient.terms.clear();
  for (std::size_t j = 0; j < cold.coefficients.size(); ++j) {
    for (const auto& term : cold.coefficients[j].terms) {
      for (const auto& [column, warmed] : dictionary_.warmed) {
        if (column != term.column) continue;
        coefficient.terms.push_back(
            {warmed, term.weight * cold.values[static_cast<Eigen::Index>(j)]});
      }
    }
  }
  if (dictionary_.nominal_drag_warmed != Dictionary::kNone) {
    coefficient.terms.push_back({dictionary_.nominal_drag_warmed, 1.0});
  }
  return coefficient;
}

Fit Fitter::fit(const Members& members) const { return fit(members, true); }

Fit Fitter::fit_unlimited(const Members& members) const { return fit(members, false); }

Fit Fitter::fit(const Members& members, bool limited) const {
  std::vector<Coefficient> coefficients = coefficients_of(members);
  Members cold;
  std::size_t scaled = Dictionary::kNone, place = always_.size();
  for (const std::size_t member : members) {
    const Variant& variant = dictionary_.variants[member];
    if (variant.scales_friction) {
      scaled = place;
    } else {
      cold.push_back(member);
    }
    place += variant.coefficients.size();
  }
  if (scaled == Dictionary::kNone) return solve(members, std::move(coefficients), limited);
  // Its column is the friction that is there: found without it, then once more with it.
  Fit fit = solve(cold, coefficients_of(cold), limited);
  for (int round = 0; round < 3 && fit.is_valid; ++round) {
    const Coefficient like = coefficients[scaled];
    coefficients[scaled] = warmed_friction(like, fit);
    fit = solve(members, coefficients, limited);
  }
  return fit;
}

Fit Fitter::solve(const Members& members, std::vector<Coefficient> coefficients,
                  bool limited) const {
  Fit fit;
  fit.members = members;
  fit.coefficients = std::move(coefficients);
  for (const Coefficient& coefficient : fit.coefficients) {
    const bool any = std::any_of(
        coefficient.terms.begin(), coefficient.terms.end(),
        [&](const auto& term) { return gram_.is_usable[term.column] && term.weight != 0.0; });
    if (!any) return fit;
  }
  const Columns selection = select(fit.coefficients, gram_.target());
  std::vector<Eigen::MatrixXd> blocks(gram_.blocks.size());
  std::vector<Eigen::MatrixXd> of_fold(
      fold_count_, Eigen::MatrixXd::Zero(selection.weights.cols(), selection.weights.cols()));
  Eigen::MatrixXd total = Eigen::MatrixXd::Zero(selection.weights.cols(), selection.weights.cols());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (folds_[b] == kNoFold) continue;
    blocks[b] = reduced(gram_.blocks[b].product, selection);
    of_fold[folds_[b]] += blocks[b];
    total += blocks[b];
  }
  const auto k = static_cast<Eigen::Index>(fit.coefficients.size());
  fit.values = solved(total);
  if (fit.values.size() != k) return fit;
  const bool is_possible =
      within_limits(fit.coefficients, fit.values) &&
      are_tight_spots_possible(dictionary_, members, always_.size(), fit.values);
  if (limited && !is_possible) return fit;
  for (const Eigen::MatrixXd& part : of_fold) {
    fit.left_out.push_back(solved(total - part));
    if (fit.left_out.back().size() != k) return fit;
  }
  fit.block_loss.assign(blocks.size(), 0.0);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (folds_[b] == kNoFold) continue;
    const Eigen::VectorXd vector = with_target(fit.left_out[folds_[b]]);
    fit.block_loss[b] = vector.dot(blocks[b] * vector);
    fit.loss += fit.block_loss[b];
  }
  fit.covariance = sandwich(blocks, total, fit.values);
  fit.is_valid = std::isfinite(fit.loss);
  return fit;
}

std::optional<Fit> Fitter::fit_whole(const Members& members, bool for_errors) const {
  Fit fit;
  fit.members = members;
  fit.coefficients = coefficients_of(members);
  const Columns selection = select(fit.coefficients, gram_.target());
  const Eigen::Index size = selection.weights.cols(), k = size - 1;
  Eigen::MatrixXd total = Eigen::MatrixXd::Zero(size, size);
  std::vector<Eigen::MatrixXd> blocks;
  for (std::size_t b = 0; b < folds_.size(); ++b) {
    if (folds_[b] == kNoFold) continue;
    blocks.push_back(reduced(gram_.blocks[b].product, selection));
    total += blocks.back();
  }
  fit.values = solved(total, for_errors ? kSingular : kDependent);
  if (fit.values.size() != k) return std::nullopt;
  fit.covariance = sandwich(blocks, total, fit.values);
  return fit;
}

Eigen::VectorXd Fitter::combination(const std::vector<Coefficient>& coefficients,
                                    const Eigen::VectorXd& values) const {
  Eigen::VectorXd vector = Eigen::VectorXd::Zero(gram_.noise.rows());
  for (std::size_t j = 0; j < coefficients.size(); ++j) {
    for (const auto& term : coefficients[j].terms) {
      vector[static_cast<Eigen::Index>(term.column)] +=
          term.weight * values[static_cast<Eigen::Index>(j)];
    }
  }
  return vector;
}

double Fitter::difference(const Fit& a, const Fit& b, std::size_t block) const {
  const std::size_t fold = folds_[block];
  const Eigen::VectorXd delta =
      combination(a.coefficients, a.left_out[fold]) - combination(b.coefficients, b.left_out[fold]);
  std::vector<Eigen::Index> used;
  for (Eigen::Index c = 0; c < delta.size(); ++c) {
    if (delta[c] != 0.0) used.push_back(c);
  }
  const Eigen::VectorXd few = delta(used);
  return few.dot(gram_.blocks[block].product(used, used) * few);
}

double Fitter::loss_on(const Fit& fit, bool held_out) const {
  Eigen::VectorXd vector = combination(fit.coefficients, fit.values);
  vector[gram_.target()] = -1.0;
  std::vector<Eigen::Index> used;
  for (Eigen::Index c = 0; c < vector.size(); ++c) {
    if (vector[c] != 0.0) used.push_back(c);
  }
  const Eigen::VectorXd few = vector(used);
  double loss = 0.0;
  for (std::size_t b = 0; b < folds_.size(); ++b) {
    if ((folds_[b] == kNoFold) == held_out) {
      loss += few.dot(gram_.blocks[b].product(used, used) * few);
    }
  }
  return loss;
}

std::pair<double, double> Fitter::slope(const Fit& fit, std::size_t coefficient,
                                        std::size_t block) const {
  Eigen::VectorXd residual = -combination(fit.coefficients, fit.values);
  residual[gram_.target()] = 1.0;
  Eigen::VectorXd column = Eigen::VectorXd::Zero(residual.size());
  for (const auto& term : fit.coefficients[coefficient].terms) {
    column[static_cast<Eigen::Index>(term.column)] += term.weight;
  }
  const Eigen::VectorXd product = gram_.blocks[block].product * column;
  return {product.dot(residual), product.dot(column)};
}

double Fitter::noise_loss(const Fit& fit) const {
  Eigen::VectorXd vector = combination(fit.coefficients, fit.values);
  vector[gram_.target()] = -1.0;
  return vector.dot(gram_.noise * vector) / gram_.samples;
}

double Fitter::samples(bool held_out) const {
  double sum = 0.0;
  for (std::size_t b = 0; b < folds_.size(); ++b) {
    if ((folds_[b] == kNoFold) == held_out) sum += gram_.blocks[b].samples;
  }
  return sum;
}

}  // namespace torquewright::identification
