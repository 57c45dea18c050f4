// SPDX-License-Identifier: Apache-2.0
#include "bench/peers/torque_regressions.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace torquewright::bench {
namespace {

using identification::Coefficient;
using identification::EquationFit;
using identification::Fitter;
using identification::Variant;

constexpr double kSignificant = 3.0;  ///< |t|.
constexpr double kDependent = 1e-8;   ///< Of a column's power, that others leave of it.
constexpr std::size_t kMostSteps = 12;

/// Ordinary least squares from the products of all samples that may be fitted.
class LeastSquares {
 public:
  explicit LeastSquares(const EquationFit& fit) : fit_(fit) {
    const auto& gram = fit.fitter().gram();
    product_ = Eigen::MatrixXd::Zero(gram.noise.rows(), gram.noise.rows());
    for (std::size_t b = 0; b < gram.blocks.size(); ++b) {
      if (fit.folds().of_block[b] == Fitter::kNoFold) continue;
      product_ += gram.blocks[b].product;
      samples_ += gram.blocks[b].samples;
    }
  }

  const EquationFit& fit() const { return fit_; }
  double samples() const { return samples_; }

  struct Result {
    std::vector<std::size_t> kept;  ///< Of the coefficients.
    Eigen::VectorXd t;              ///< Of those.
    double rest = 0.0;
  };

  Result solve(const std::vector<Coefficient>& coefficients) const {
    const Eigen::Index target = product_.rows() - 1;
    Result result;
    Eigen::MatrixXd columns(product_.rows(), 0);
    for (std::size_t k = 0; k < coefficients.size(); ++k) {
      Eigen::MatrixXd more(product_.rows(), columns.cols() + 1);
      more << columns, weights(coefficients[k]);
      if (!is_independent(more)) continue;
      columns = more;
      result.kept.push_back(k);
    }
    const double power = product_(target, target);
    if (columns.cols() == 0) return {{}, {}, power};
    const Eigen::MatrixXd normal = columns.transpose() * product_ * columns;
    const Eigen::VectorXd right = columns.transpose() * product_.col(target);
    const Eigen::LDLT<Eigen::MatrixXd> factors(normal);
    const Eigen::VectorXd values = factors.solve(right);
    result.rest = std::max(1e-300, power - right.dot(values));
    const double variance =
        result.rest / std::max(1.0, samples_ - static_cast<double>(values.size()));
    const Eigen::MatrixXd inverse =
        factors.solve(Eigen::MatrixXd::Identity(normal.rows(), normal.cols()));
    result.t = values.array() / (variance * inverse.diagonal().array()).abs().sqrt();
    return result;
  }

 private:
  Eigen::VectorXd weights(const Coefficient& coefficient) const {
    Eigen::VectorXd weight = Eigen::VectorXd::Zero(product_.rows());
    for (const auto& term : coefficient.terms) {
      weight[static_cast<Eigen::Index>(term.column)] += term.weight;
    }
    return weight;
  }

  /// The last column stands out of those before it.
  bool is_independent(const Eigen::MatrixXd& columns) const {
    const Eigen::MatrixXd normal = columns.transpose() * product_ * columns;
    const Eigen::Index last = normal.rows() - 1;
    if (!(normal(last, last) > 0.0)) return false;
    if (last == 0) return true;
    const Eigen::VectorXd beside = normal.col(last).head(last);
    const Eigen::LDLT<Eigen::MatrixXd> factors(normal.topLeftCorner(last, last));
    return normal(last, last) - beside.dot(factors.solve(beside)) > kDependent * normal(last, last);
  }

  const EquationFit& fit_;
  Eigen::MatrixXd product_;
  double samples_ = 0.0;
};

void append(std::vector<Coefficient>& list, const std::vector<Coefficient>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

/// Variants with columns of their own.
std::vector<std::size_t> candidates(const EquationFit& fit) {
  std::vector<std::size_t> list;
  const auto& variants = fit.equation().dictionary.variants;
  for (std::size_t v = 0; v < variants.size(); ++v) {
    if (!variants[v].scales_friction && fit.is_excited(v)) list.push_back(v);
  }
  return list;
}

/// Of each effect the variant that alone leaves least.
std::map<std::string, std::size_t> best_variants(const LeastSquares& squares) {
  std::map<std::string, std::size_t> best;
  std::map<std::string, double> rest;
  const auto& variants = squares.fit().equation().dictionary.variants;
  for (const std::size_t v : candidates(squares.fit())) {
    std::vector<Coefficient> coefficients = squares.fit().equation().always;
    append(coefficients, variants[v].coefficients);
    const double left = squares.solve(coefficients).rest;
    const std::string& effect = variants[v].effect;
    if (best.contains(effect) && rest[effect] <= left) continue;
    best[effect] = v;
    rest[effect] = left;
  }
  return best;
}

std::vector<std::string> significant(const LeastSquares& squares,
                                     const std::map<std::string, std::size_t>& effects) {
  const auto& equation = squares.fit().equation();
  std::vector<Coefficient> coefficients = equation.always;
  std::vector<std::string> owner(coefficients.size());
  // What holds others (asymmetric friction holds Coulomb's) comes after them: the rest of it
  // counts.
  for (const bool holds_others : {false, true}) {
    for (const auto& [effect, v] : effects) {
      if (equation.dictionary.variants[v].replaces.empty() == holds_others) continue;
      append(coefficients, equation.dictionary.variants[v].coefficients);
      owner.resize(coefficients.size(), effect);
    }
  }
  const LeastSquares::Result result = squares.solve(coefficients);
  std::vector<std::string> named;
  for (std::size_t k = 0; k < result.kept.size(); ++k) {
    const std::string& effect = owner[result.kept[k]];
    if (effect.empty() || !(std::abs(result.t[static_cast<Eigen::Index>(k)]) > kSignificant))
      continue;
    if (std::find(named.begin(), named.end(), effect) == named.end()) named.push_back(effect);
  }
  return named;
}

}  // namespace

std::vector<std::string> fixed_friction(const EquationFit& fit) {
  const LeastSquares squares(fit);
  std::map<std::string, std::size_t> chosen;
  for (const auto& [effect, v] : best_variants(squares)) {
    if (effect == "coulomb_friction" || effect == "viscous_friction") chosen[effect] = v;
  }
  return significant(squares, chosen);
}

std::vector<std::string> everything(const EquationFit& fit) {
  const LeastSquares squares(fit);
  return significant(squares, best_variants(squares));
}

std::vector<std::string> greedy_by_bic(const EquationFit& fit) {
  const LeastSquares squares(fit);
  const auto& equation = fit.equation();
  const double n = squares.samples();
  std::vector<Coefficient> model = equation.always;
  const auto criterion = [&](const std::vector<Coefficient>& coefficients) {
    const LeastSquares::Result result = squares.solve(coefficients);
    return n * std::log(result.rest / n) + static_cast<double>(result.kept.size()) * std::log(n);
  };
  double best = criterion(model);
  std::vector<std::string> named;
  for (std::size_t step = 0; step < kMostSteps; ++step) {
    std::optional<std::size_t> chosen;
    for (const std::size_t v : candidates(fit)) {
      std::vector<Coefficient> with = model;
      append(with, equation.dictionary.variants[v].coefficients);
      const double value = criterion(with);
      if (value >= best) continue;
      best = value;
      chosen = v;
    }
    if (!chosen) break;
    const Variant& variant = equation.dictionary.variants[*chosen];
    append(model, variant.coefficients);
    if (std::find(named.begin(), named.end(), variant.effect) == named.end()) {
      named.push_back(variant.effect);
    }
  }
  return named;
}

}  // namespace torquewright::bench
