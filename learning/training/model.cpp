// SPDX-License-Identifier: Apache-2.0
#include "learning/training/model.hpp"

#include <cmath>
#include <cstdint>

namespace torquewright::learning {
namespace {

/// Streams of random numbers that are no copy's.
constexpr std::uint64_t kWeightsStream = std::uint64_t{1} << 40;

/// The first actions are drawn about zero, whatever is seen; values begin small but not dead.
constexpr double kLastOfActor = 0.01;
constexpr double kLastOfOthers = 0.5;

/// Iterations after which returns are forgotten.
constexpr double kReturnsMemory = 10.0;
constexpr double kLeastReturnsDeviation = 1e-3;

NetworkShape shape_of(int inputs, const std::vector<int>& hidden, int outputs,
                      const Activation& activation) {
  NetworkShape shape{{inputs}, activation};
  shape.widths.insert(shape.widths.end(), hidden.begin(), hidden.end());
  shape.widths.push_back(outputs);
  return shape;
}

std::vector<Learner> critics_of(const Sizes& sizes, const TrainerOptions& options) {
  const int count = options.separate_critics ? sizes.heads : 1;
  const int outputs = options.separate_critics ? 1 : sizes.heads;
  std::vector<Learner> critics;
  for (int i = 0; i < count; ++i) {
    Generator generator(options.seed, kWeightsStream + 2 + static_cast<std::uint64_t>(i));
    critics.emplace_back(
        shape_of(sizes.critic_inputs, options.critic_layers, outputs, options.activation),
        generator, kLastOfOthers);
  }
  return critics;
}

Learner actor_of(const Sizes& sizes, const TrainerOptions& options) {
  Generator generator(options.seed, kWeightsStream);
  const int inputs = sizes.actor_inputs + static_cast<int>(options.estimated.size());
  return {shape_of(inputs, options.actor_layers, sizes.actions, options.activation), generator,
          kLastOfActor};
}

std::optional<Learner> estimator_of(const Sizes& sizes, const TrainerOptions& options) {
  if (options.estimated.empty()) return std::nullopt;
  Generator generator(options.seed, kWeightsStream + 1);
  return Learner(shape_of(sizes.actor_inputs, options.estimator_layers,
                          static_cast<int>(options.estimated.size()), options.activation),
                 generator, kLastOfOthers);
}

}  // namespace

UsualInputs::UsualInputs(Eigen::Index size, double least)
    : moments(size),
      least_deviation(least),
      mean(Eigen::VectorXf::Zero(size)),
      inverse_deviation(Eigen::VectorXf::Ones(size)) {}

void UsualInputs::renew() {
  mean = moments.mean().cast<float>();
  inverse_deviation = moments.deviation(least_deviation).cwiseInverse().cast<float>();
}

Learner::Learner(NetworkShape shape, Generator& generator, double last)
    : network(std::move(shape)), adam(network.parameters().size()) {
  network.draw(generator, last);
}

Model::Model(const Sizes& sizes, const TrainerOptions& options)
    : actor_inputs(sizes.actor_inputs, options.least_input_deviation),
      critic_inputs(sizes.critic_inputs, options.least_input_deviation),
      estimator(estimator_of(sizes, options)),
      actor(actor_of(sizes, options)),
      critics(critics_of(sizes, options)),
      log_deviations(Eigen::VectorXd::Constant(sizes.actions, std::log(options.first_deviation))),
      deviations_adam(sizes.actions),
      returns(sizes.heads, kReturnsMemory * options.copies * options.steps_per_iteration),
      rate(options.first_rate) {}

ValueScale value_scale_of(const Model& model) {
  return {model.returns.mean(), model.returns.deviation(kLeastReturnsDeviation)};
}

void renew_value_scale(const Eigen::Ref<const Eigen::MatrixXf>& returns, Model& model) {
  const ValueScale old = value_scale_of(model);
  model.returns.add(returns);
  const ValueScale now = value_scale_of(model);
  for (int head = 0; head < static_cast<int>(old.mean.size()); ++head) {
    Network<float>& critic = model.critics[static_cast<std::size_t>(model.critic_of(head))].network;
    const int last = critic.layers() - 1;
    const int output = model.output_of(head);
    const double stretch = old.deviation(head) / now.deviation(head);
    const double shift = (old.mean(head) - now.mean(head)) / now.deviation(head);
    auto weights = critic.weights(last);
    auto bias = critic.bias(last);
    weights.row(output) *= static_cast<float>(stretch);
    bias(output) = static_cast<float>(stretch * bias(output) + shift);
  }
}

Policy policy_of(const Model& model) {
  Policy policy;
  policy.normalisation.mean = model.actor_inputs.mean.cast<double>();
  policy.normalisation.deviation =
      model.actor_inputs.inverse_deviation.cast<double>().cwiseInverse();
  if (model.estimator) policy.estimator = model.estimator->network.as_layers();
  policy.layers = model.actor.network.as_layers();
  return policy;
}

}  // namespace torquewright::learning
