// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "identification/forward/equation.hpp"
#include "identification/signals/rows.hpp"

namespace torquewright::identification {

/// The effects that a model holds beside the stated ones.
using EffectSet = std::vector<const EffectCandidate*>;

/// Sums over a block of products of the residual's slopes, less what the channels' noise adds.
struct BlockSums {
  Eigen::MatrixXd slopes;   ///< (p x p) Slopes times slopes.
  Eigen::VectorXd descent;  ///< (p x 1) Slopes times residual.
  double loss = 0.0;        ///< Sum of the squared residual.
  double noise = 0.0;       ///< What noise adds to it; `loss` is without that already.
};

/// A model fitted to the training rows by bounded least squares on the forward model.
struct ModelFit {
  EffectSet members;
  /// (p x 1) Coordinates of what is always fitted, then of each member.
  Eigen::VectorXd coordinates;
  Eigen::VectorXd residual;  ///< (n x 1) Residual of the rows.
  Eigen::VectorXd noise;     ///< (n x 1) Change of the residual by noise that is added once more.
  std::vector<BlockSums> sums;  ///< Sums by block.
  /// (p x p) Covariance of the coordinates, by the scatter of blocks and of folds.
  Eigen::MatrixXd covariance;
  std::vector<bool> is_free;   ///< False: the coordinate is held at a bound.
  std::vector<double> unseen;  ///< Loss of each block where it was not fitted.
  double loss = 0.0;           ///< Loss of the training blocks, fitted.
  double unseen_loss = 0.0;    ///< Loss of the training blocks, each where it was not fitted.
  double noise_loss = 0.0;     ///< What noise adds to the loss of the training blocks.
  bool is_valid = false;

  bool holds(const std::string& effect) const;
  /// Index of a member's first coordinate.
  Eigen::Index first_of(std::size_t member) const;
  /// Number of coordinates that are always fitted; the rest are the members'.
  Eigen::Index always = 0;
};

/// Some members of a model, with their coordinates as they were fitted beside the others.
struct PartOfModel {
  EffectSet members;
  Eigen::VectorXd coordinates;  ///< Coordinates of what is always fitted, then of each member.
};

PartOfModel part_of(const ModelFit& fit,
                    const std::function<bool(const EffectCandidate& member)>& stays);

/// Fits models of one equation by bounded least squares.
class ModelFitter {
 public:
  /// Keeps references to all three. `replica`: the rows' signals with noise added once more.
  ModelFitter(const ForwardEquation& equation, const Rows& rows,
              const std::vector<Signals>& replica);

  /// Fits from a start of all coordinates: those of `always`, then those of the members.
  ModelFit fit(const EffectSet& members, const Eigen::VectorXd& start) const;

  /// Returns the coordinates at which fits of `always` start.
  Eigen::VectorXd always_start() const;

  Hypothesis hypothesis(const EffectSet& members, const Eigen::VectorXd& coordinates) const;
  Eigen::VectorXd residual(const EffectSet& members, const Eigen::VectorXd& coordinates) const;
  /// Returns what noise that is added once more changes of the residual.
  Eigen::VectorXd noise(const EffectSet& members, const Eigen::VectorXd& coordinates) const;
  /// (n x p) Returns the slopes of the residual at coordinates where it is `residual`. `like`: see
  /// Rows.
  Eigen::MatrixXd slopes(const EffectSet& members, const Eigen::VectorXd& coordinates,
                         const Eigen::VectorXd& residual, const std::vector<Signals>& like) const;

  const ForwardEquation& equation() const { return equation_; }
  const Rows& rows() const { return rows_; }

 private:
  std::vector<FitParameter> parameters(const EffectSet& members) const;
  Eigen::VectorXd residual(const EffectSet& members, const Eigen::VectorXd& coordinates,
                           const std::vector<Signals>& like) const;
  ResidualOfStretch residual_on(const std::vector<Signals>& stretches) const;
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
  ResidualOfStretch of_rows_, of_replica_;
};

}  // namespace torquewright::identification
