// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "learning/network/activation.hpp"

namespace torquewright::learning {

/// One fully connected layer: y = activation(weights x + bias).
struct Layer {
  Eigen::MatrixXd weights;  // (outputs x inputs)
  Eigen::VectorXd bias;     // (outputs x 1)
  Activation activation;
};

/// What a network sees of an input x: (x - mean) / deviation, entry by entry.
struct Normalisation {
  Eigen::VectorXd mean;
  Eigen::VectorXd deviation;  ///< All above 0.
};

/// What was learned, as it is used: the mean action for an observation. Numbers have no units here.
///
///   z = (observation - mean) / deviation;   action = layers([z; estimator(z)])
///
/// The estimator guesses the part of the critic's view that it was trained on, normalised; without
/// one (no layers) the network sees z alone.
struct Policy {
  Normalisation normalisation;
  std::vector<Layer> estimator;
  std::vector<Layer> layers;

  int inputs() const { return static_cast<int>(normalisation.mean.size()); }
  int outputs() const { return static_cast<int>(layers.back().bias.size()); }
};

/// Empty where the sizes of a policy fit together and all numbers are finite, deviations above 0;
/// else a sentence that says which do not.
std::string objection_to(const Policy& policy);

/// Evaluates one policy, again and again, without allocating. Keeps a copy of the policy. One
/// object serves one thread at a time.
class PolicyEvaluation {
 public:
  /// Requires a policy without objection.
  explicit PolicyEvaluation(Policy policy);
  const Policy& policy() const { return policy_; }
  /// The action (outputs x 1) for an observation (inputs x 1), which is finite.
  const Eigen::VectorXd& action(const Eigen::Ref<const Eigen::VectorXd>& observation);
  /// What the estimator guessed at the last call (0 x 1 without one), normalised.
  Eigen::Ref<const Eigen::VectorXd> guess() const;

 private:
  Policy policy_;
  Eigen::VectorXd seen_;  // [z; guess]
  std::vector<Eigen::VectorXd> guessed_;
  std::vector<Eigen::VectorXd> values_;
};

}  // namespace torquewright::learning
