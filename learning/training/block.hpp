// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "learning/formulas/surrogate.hpp"
#include "learning/training/model.hpp"
#include "learning/training/samples.hpp"
#include "learning/training/trainer_options.hpp"

namespace torquewright::learning {

/// Sums over samples of what is reported of learning.
struct LossSums {
  SurrogateSums surrogate;
  double value = 0.0;      ///< Mean over heads of the squared error.
  double estimator = 0.0;  ///< Mean over guesses of the squared error.
  double symmetry = 0.0;   ///< Mean over actions of the squared difference.

  void add(const LossSums& more);
};

/// What a block of samples adds to the gradients of all networks.
struct BlockGradient {
  explicit BlockGradient(const Model& model);

  Eigen::VectorXf actor;
  Eigen::VectorXd log_deviations;
  std::vector<Eigen::VectorXf> critics;
  Eigen::VectorXf estimator;
  LossSums sums;
};

/// Where a thread computes; it keeps its memory.
struct BlockRoom {
  explicit BlockRoom(const Model& model);

  Network<float>::Pass actor;
  Network<float>::Pass estimator;
  Network<float>::Pass mirrored_estimator;
  std::vector<Network<float>::Pass> critics;
  Eigen::MatrixXf actions, old_means, errors;
  Eigen::VectorXf advantages;
  Eigen::VectorXf mirrored;
};

/// What a block's gradient is of.
struct BlockTask {
  const TrainerOptions& options;
  const Model& model;
  const Samples& samples;
  const Eigen::VectorXd& old_log_deviations;  ///< Under which the samples acted.
  double weight;  ///< Of a sample: one over the number of the minibatch.
};

/// The gradient of these samples' losses (replacing what was there): of the surrogate and the
/// symmetry for the actor, of squared errors for critics and estimator.
void block_gradient(const BlockTask& task, std::span<const int> samples, BlockRoom& room,
                    BlockGradient& gradient);

}  // namespace torquewright::learning
