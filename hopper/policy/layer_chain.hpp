// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "learning/network/policy.hpp"

namespace torquewright::hopper {

/// What has become of the input so far: z = scale * input + shift, perhaps an estimator's guess
/// beside it, then layers. Linear steps without an activation between them are one.
class LayerChain {
 public:
  explicit LayerChain(Eigen::Index inputs);

  Eigen::Index outputs() const;
  bool has_layers() const { return !layers_.empty(); }

  /// y = factor * x + summand, entry by entry.
  void scale(const Eigen::VectorXd& factor, const Eigen::VectorXd& summand);
  /// y = weights x + bias.
  void multiply(const Eigen::MatrixXd& weights, const Eigen::VectorXd& bias);
  void activate(const learning::Activation& activation);

  /// True where the other one is layers behind what this one is, and this one has none.
  bool can_be_guessed_by(const LayerChain& other) const;
  /// Puts the other's outputs behind its own. Requires can_be_guessed_by(other).
  void put_guess(const LayerChain& other);

  /// Requires at least one output.
  learning::Policy policy() const;

 private:
  bool is_linear_so_far() const;

  Eigen::VectorXd scale_;
  Eigen::VectorXd shift_;
  std::vector<learning::Layer> estimator_;
  std::vector<learning::Layer> layers_;
};

}  // namespace torquewright::hopper
