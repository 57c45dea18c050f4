// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "identification/gram.hpp"

namespace torquewright::identification {

/// A set of variants (indices into the dictionary) that together explain a residual.
using Members = std::vector<std::size_t>;

/// A model fitted to all blocks of the folds, and its losses where each fold was left out of the
/// fit. Losses are sums of squares over samples, freed from the channels' noise, in the target's
/// unit squared. Its k coefficients have units of their own.
struct Fit {
  bool is_valid = false;  ///< Determined, and every coefficient within its limits.
  Members members;
  std::vector<Coefficient> coefficients;  ///< Those that stand always, then of each member.
  Eigen::VectorXd values;                 ///< (k x 1) Of the coefficients.
  Eigen::MatrixXd covariance;             ///< (k x k) By the spread of the blocks' scores.
  std::vector<Eigen::VectorXd> left_out;  ///< By fold: values (k x 1) without it.
  std::vector<double> block_loss;         ///< Each by the fit that did not see its fold.
  double loss = 0.0;                      ///< Their sum.
  std::size_t first_of_member(const Dictionary& dictionary, std::size_t member,
                              std::size_t always) const;
};

/// Fits sets of variants to a Gram. Blocks without a fold take no part.
class Fitter {
 public:
  /// `folds`: of each block; kNoFold: held out from everything. `always`: coefficients that stand
  /// in every model (values of the rig or actuator that are uncertain).
  Fitter(const Gram& gram, const Dictionary& dictionary, std::vector<std::size_t> folds,
         std::vector<Coefficient> always);
  static constexpr std::size_t kNoFold = static_cast<std::size_t>(-1);

  Fit fit(const Members& members) const;

  /// The same without limits: what an addition is measured against.
  Fit fit_unlimited(const Members& members) const;

  /// The same without anything left out, and without limits. Empty where it is not determined;
  /// `for_errors`: only where not even an error can be given.
  std::optional<Fit> fit_whole(const Members& members, bool for_errors = false) const;
  bool is_determined(const Members& members) const { return fit_whole(members).has_value(); }

  void set_always(std::vector<Coefficient> always) { always_ = std::move(always); }

  /// Sum of squared differences of two models' predictions in a block, each by its fit without the
  /// block's fold.
  double difference(const Fit& a, const Fit& b, std::size_t block) const;

  /// Loss of a fit's values (to all folds) on blocks of one kind: held out (true) or not.
  double loss_on(const Fit& fit, bool held_out) const;
  /// Of one coefficient in one block: its combined column's product with the residual, and with
  /// itself.
  std::pair<double, double> slope(const Fit& fit, std::size_t coefficient, std::size_t block) const;

  double noise_loss(const Fit& fit) const;  ///< v' N v over the whole log, per sample.
  double samples(bool held_out) const;

  std::size_t fold_count() const { return fold_count_; }
  const std::vector<std::size_t>& folds() const { return folds_; }
  const Gram& gram() const { return gram_; }
  const Dictionary& dictionary() const { return dictionary_; }
  std::size_t always_count() const { return always_.size(); }
  const std::vector<Coefficient>& always() const { return always_; }

 private:
  Fit fit(const Members& members, bool limited) const;
  Fit solve(const Members& members, std::vector<Coefficient> coefficients, bool limited) const;
  std::vector<Coefficient> coefficients_of(const Members& members) const;
  Coefficient warmed_friction(const Coefficient& like, const Fit& cold) const;
  /// ((m+1) x 1) What k values weigh the columns with; 0 for the target.
  Eigen::VectorXd combination(const std::vector<Coefficient>& coefficients,
                              const Eigen::VectorXd& values) const;

  const Gram& gram_;
  const Dictionary& dictionary_;
  std::vector<std::size_t> folds_;
  std::size_t fold_count_ = 0;
  std::vector<Coefficient> always_;
};

}  // namespace torquewright::identification
