// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "learning/network/activation.hpp"
#include "learning/training/mirror.hpp"

namespace torquewright::learning {

/// Proximal policy optimisation (Schulman et al. 2017) as legged robots are trained with it. The
/// defaults are those of a flip that was learned (two cores, four minutes).
struct TrainerOptions {
  std::uint64_t seed = 1;
  int threads = 1;  ///< Changes no byte of the result.

  int copies = 64;                ///< Environments side by side.
  int steps_per_iteration = 200;  ///< Of each copy.
  int epochs = 4;                 ///< Times that an iteration's samples are gone through.
  int minibatch = 3200;           ///< Samples of one step of Adam; too few: noise, too many: slow.

  std::vector<double> discounts = {0.99};  ///< One per head, or one for all.
  double lambda = 0.95;                    ///< Of generalised advantages, 0 to 1.
  double clip = 0.2;                       ///< Ratio of probabilities that still earns.
  double entropy = 0.01;                   ///< Price of certainty.
  double target_kl = 0.01;  ///< Rate is divided by 1.5 above twice it, multiplied below half of it.
  double first_rate = 3e-4;
  double least_rate = 5e-5;
  double greatest_rate = 1e-3;
  double value_rate = 1e-3;      ///< Of critics and estimator, constant.
  double greatest_gradient = 1;  ///< Norm to which gradients are shortened.

  double first_deviation = 0.6;  ///< Of actions, before anything is learned.
  double least_deviation = 0.2;  ///< Never less: a flip that is too certain too early stays bad.
  double least_input_deviation = 1e-2;  ///< Inputs that vary less are divided by this.

  std::vector<int> actor_layers = {256, 128, 64};
  std::vector<int> critic_layers = {256, 128, 64};
  bool separate_critics = false;  ///< A network for each head, rather than one with many outputs.
  Activation activation;

  std::vector<int> estimated;  ///< Entries of the critic's view that the estimator is to guess;
                               ///< empty: no estimator.
  std::vector<int> estimator_layers = {256, 128};

  std::optional<Mirror> mirror;
  double symmetry = 1.0;  ///< Weight of |action - mirrored action of the mirrored|^2, if mirrored.
};

}  // namespace torquewright::learning
