// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "learning/team.hpp"
#include "learning/training/block.hpp"
#include "learning/training/iteration_report.hpp"

namespace torquewright::learning {

/// Goes through an iteration's samples in minibatches of random order, and takes a step of Adam for
/// each. A minibatch's gradient is the sum of those of blocks, in their order, and blocks do not
/// depend on the number of threads.
class Learning {
 public:
  explicit Learning(const TrainerOptions& options) : options_(options) {}

  /// Throws std::domain_error where a gradient is not finite.
  void run(const Samples& samples, Generator order, Model& model, Team& team,
           IterationReport& report);

 private:
  void make_room(int blocks, const Model& model, const Team& team);
  LossSums sum_of_blocks(const BlockTask& task, std::span<const int> minibatch, Team& team);
  void take_steps(int blocks, Model& model, Team& team);
  void step_actor(int blocks, Model& model);
  void steer_rate(double kl, Model& model) const;

  TrainerOptions options_;
  std::vector<BlockRoom> rooms_;          // of threads
  std::vector<BlockGradient> gradients_;  // of blocks
  std::vector<int> order_;
};

}  // namespace torquewright::learning
