// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "identification/forward/equation.hpp"
#include "identification/signals/rows.hpp"

namespace torquewright::identification {

/// Which effects a model holds, beside what is stated.
using EffectSet = std::vector<const EffectCandidate*>;

/// Sums over a block: products of the residual's slopes, less what the channels' noise adds.
struct BlockSums {
  Eigen::MatrixXd slopes;   ///< (p x p)
  Eigen::VectorXd descent;  ///< (p x 1) Slopes times residual.
  double loss = 0.0;        ///< Residual squared.
  double noise = 0.0;       ///< What noise adds to that; it is taken off there.
};

/// A model fitted to the training rows by bounded least squares on the forward model.
struct ModelFit {
  EffectSet members;
  Eigen::VectorXd coordinates;  ///< (p x 1) Of what is always fitted, then of each member.
  Eigen::VectorXd residual;     ///< (n x 1)
  Eigen::VectorXd noise;        ///< (n x 1) What noise added once more changes.
  std::vector<BlockSums> sums;  ///< By block.
  Eigen::MatrixXd covariance;   ///< (p x p) By the scatter of blocks and of folds.
  std::vector<bool> is_free;    ///< Not at a bound that holds it.
  std::vector<double> unseen;   ///< By block: loss where it was not fitted.
  double loss = 0.0;            ///< Of the training blocks, fitted.
  double unseen_loss = 0.0;     ///< Of the same, each where it was not fitted.
  double noise_loss = 0.0;      ///< Of the training blocks.
  bool is_valid = false;

  bool holds(const std::string& effect) const;
  /// First coordinate of a member.
  Eigen::Index first_of(std::size_t member) const;
  /// That of all parameters which are always fitted: the rest is members'.
  Eigen::Index always = 0;
};

/// Fits models of one equation.
class ModelFitter {
 public:
  /// Keeps references to all three. `replica`: the rows' signals with noise added once more.
  ModelFitter(const ForwardEquation& equation, const Rows& rows,
              const std::vector<Signals>& replica);

  /// From coordinates of all parameters: those of `always`, then of the members.
  ModelFit fit(const EffectSet& members, const Eigen::VectorXd& start) const;

  /// The coordinates of what is always fitted, at which fits start.
  Eigen::VectorXd always_start() const;

  Hypothesis hypothesis(const EffectSet& members, const Eigen::VectorXd& coordinates) const;
  Eigen::VectorXd residual(const EffectSet& members, const Eigen::VectorXd& coordinates) const;
  /// (n x p) Its slopes at coordinates where it is `residual`. `like`: see Rows.
  Eigen::MatrixXd slopes(const EffectSet& members, const Eigen::VectorXd& coordinates,
                         const Eigen::VectorXd& residual, const std::vector<Signals>& like) const;

  const ForwardEquation& equation() const { return equation_; }
  const Rows& rows() const { return rows_; }

 private:
  std::vector<FitParameter> parameters(const EffectSet& members) const;
  Eigen::VectorXd residual(const EffectSet& members, const Eigen::VectorXd& coordinates,
                           const std::vector<Signals>& like) const;
  struct Point;
  struct Stated;
  Stated stated(Eigen::Index count) const;
  Point descended(const EffectSet& members, const std::vector<FitParameter>& all, Point here) const;
  Point point(const EffectSet& members, const Eigen::VectorXd& coordinates) const;
  void add_slopes(const EffectSet& members, Point& point) const;
  void add_products(Point& point) const;
  void finish(const std::vector<FitParameter>& parameters, const Point& point, ModelFit& fit) const;

  const ForwardEquation& equation_;
  const Rows& rows_;
  const std::vector<Signals>& replica_;
};

}  // namespace torquewright::identification
