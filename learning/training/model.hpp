// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "learning/environment.hpp"
#include "learning/formulas/running_moments.hpp"
#include "learning/network/adam.hpp"
#include "learning/network/network.hpp"
#include "learning/training/trainer_options.hpp"

namespace torquewright::learning {

/// How networks see what they are shown: (x - mean) / deviation, the same until it is renewed.
struct UsualInputs {
  UsualInputs(Eigen::Index size, double least_deviation);
  void renew();
  /// What a network is shown of a view.
  void show(const Eigen::Ref<const Eigen::VectorXf>& view,
            Eigen::Ref<Eigen::VectorXf> shown) const {
    shown = (view - mean).cwiseProduct(inverse_deviation);
  }

  RunningMoments moments;  ///< Of all that was shown so far.
  double least_deviation;
  Eigen::VectorXf mean;
  Eigen::VectorXf inverse_deviation;
};

/// A network and its optimiser.
struct Learner {
  Learner(NetworkShape shape, Generator& generator, double last);

  Network<float> network;
  Adam<float> adam;
};

/// All that is learned.
struct Model {
  Model(const Sizes& sizes, const TrainerOptions& options);

  /// The critic that knows that head, and which of its outputs that is.
  int critic_of(int head) const { return critics.size() == 1 ? 0 : head; }
  int output_of(int head) const { return critics.size() == 1 ? head : 0; }

  UsualInputs actor_inputs;
  UsualInputs critic_inputs;
  std::optional<Learner> estimator;
  Learner actor;
  std::vector<Learner> critics;    ///< One for all heads, or one for each.
  Eigen::VectorXd log_deviations;  ///< Of actions.
  Adam<double> deviations_adam;
  RunningMoments returns;  ///< Of each head: critics know (value - mean) / deviation.
  double rate;
};

/// The returns' scale: a value is mean + deviation times the critic's output, head by head.
struct ValueScale {
  Eigen::VectorXd mean;
  Eigen::VectorXd deviation;
};
ValueScale value_scale_of(const Model& model);

/// Takes these returns (heads x samples) into account, and changes the critics' last layers so that
/// their values stay what they were (van Hasselt et al. 2016).
void renew_value_scale(const Eigen::Ref<const Eigen::MatrixXf>& returns, Model& model);

/// As it is used: float numbers as they are.
Policy policy_of(const Model& model);

}  // namespace torquewright::learning
