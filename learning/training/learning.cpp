// SPDX-License-Identifier: Apache-2.0
#include "learning/training/learning.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

namespace torquewright::learning {
namespace {

/// Samples of a block: enough for products of matrices, few enough that what layers say of them
/// stays in the caches.
constexpr int kMostOfBlock = 256;

int blocks_of(int samples) {
  const int count = (samples + kMostOfBlock - 1) / kMostOfBlock;
  return count > 1 ? std::min(samples, count + count % 2) : count;  // two threads share them evenly
}

int minibatches_of(const TrainerOptions& options, int samples) {
  return std::max(1, static_cast<int>(std::lround(static_cast<double>(samples) /
                                                  static_cast<double>(options.minibatch))));
}

/// The part `number` of `count` equal parts.
std::span<const int> part_of(std::span<const int> all, int number, int count) {
  const auto border = [&](int i) {
    return all.size() * static_cast<std::size_t>(i) / static_cast<std::size_t>(count);
  };
  return all.subspan(border(number), border(number + 1) - border(number));
}

void shuffle(Generator& generator, std::vector<int>& order) {
  for (std::size_t i = order.size(); i > 1; --i) {
    std::swap(order[i - 1], order[generator.below(i)]);
  }
}

/// Shortens a gradient to the norm; throws where it is not finite.
double shortening_of(double square, double most, const char* of) {
  if (!std::isfinite(square)) {
    throw std::domain_error(std::string("the gradient of the ") + of + " is not finite");
  }
  const double norm = std::sqrt(square);
  return norm > most ? most / norm : 1.0;
}

void step_network(double rate, double most, const char* name, Eigen::VectorXf& gradient,
                  Learner& learner) {
  const double square = gradient.cast<double>().squaredNorm();
  gradient *= static_cast<float>(shortening_of(square, most, name));
  learner.adam.step(gradient, rate, learner.network.parameters());
}

}  // namespace

void Learning::make_room(int blocks, const Model& model, const Team& team) {
  while (static_cast<int>(rooms_.size()) < team.threads()) rooms_.emplace_back(model);
  while (static_cast<int>(gradients_.size()) < blocks) gradients_.emplace_back(model);
}

LossSums Learning::sum_of_blocks(const BlockTask& task, std::span<const int> minibatch,
                                 Team& team) {
  const int blocks = blocks_of(static_cast<int>(minibatch.size()));
  make_room(blocks, task.model, team);
  team.run(blocks, [&](int block, int thread) {
    block_gradient(task, part_of(minibatch, block, blocks),
                   rooms_[static_cast<std::size_t>(thread)],
                   gradients_[static_cast<std::size_t>(block)]);
  });
  LossSums sums;
  for (int i = 0; i < blocks; ++i) sums.add(gradients_[static_cast<std::size_t>(i)].sums);
  return sums;
}

void Learning::steer_rate(double kl, Model& model) const {
  if (kl > 2.0 * options_.target_kl) model.rate /= 1.5;
  if (kl > 0.0 && kl < 0.5 * options_.target_kl) model.rate *= 1.5;
  model.rate = std::clamp(model.rate, options_.least_rate, options_.greatest_rate);
}

void Learning::step_actor(int blocks, Model& model) {
  BlockGradient& sum = gradients_.front();
  for (int i = 1; i < blocks; ++i) {
    sum.actor += gradients_[static_cast<std::size_t>(i)].actor;
    sum.log_deviations += gradients_[static_cast<std::size_t>(i)].log_deviations;
  }
  // The entropy is the sum of the logarithms, but for a constant.
  sum.log_deviations.array() -= options_.entropy;
  const double square = sum.actor.cast<double>().squaredNorm() + sum.log_deviations.squaredNorm();
  const double shortening = shortening_of(square, options_.greatest_gradient, "policy");
  sum.actor *= static_cast<float>(shortening);
  sum.log_deviations *= shortening;
  model.actor.adam.step(sum.actor, model.rate, model.actor.network.parameters());
  model.deviations_adam.step(sum.log_deviations, model.rate, model.log_deviations);
  model.log_deviations = model.log_deviations.cwiseMax(std::log(options_.least_deviation));
}

void Learning::take_steps(int blocks, Model& model, Team& team) {
  const auto critics = static_cast<int>(model.critics.size());
  BlockGradient& sum = gradients_.front();
  team.run(1 + critics + (model.estimator ? 1 : 0), [&](int network, int) {
    if (network == 0) return step_actor(blocks, model);
    const bool is_critic = network <= critics;
    const auto at = static_cast<std::size_t>(network - 1);
    Eigen::VectorXf& total = is_critic ? sum.critics[at] : sum.estimator;
    for (int i = 1; i < blocks; ++i) {
      const BlockGradient& block = gradients_[static_cast<std::size_t>(i)];
      total += is_critic ? block.critics[at] : block.estimator;
    }
    step_network(options_.value_rate, options_.greatest_gradient,
                 is_critic ? "critic" : "estimator", total,
                 is_critic ? model.critics[at] : *model.estimator);
  });
}

void Learning::run(const Samples& samples, Generator order, Model& model, Team& team,
                   IterationReport& report) {
  const Eigen::VectorXd old_log_deviations = model.log_deviations;
  order_.resize(static_cast<std::size_t>(samples.count()));
  std::iota(order_.begin(), order_.end(), 0);
  const int minibatches = minibatches_of(options_, samples.count());
  LossSums sums;
  for (int epoch = 0; epoch < options_.epochs; ++epoch) {
    shuffle(order, order_);
    sums = {};
    for (int i = 0; i < minibatches; ++i) {
      const std::span<const int> minibatch = part_of(order_, i, minibatches);
      const auto size = static_cast<double>(minibatch.size());
      const BlockTask task{options_, model, samples, old_log_deviations, 1.0 / size};
      const LossSums here = sum_of_blocks(task, minibatch, team);
      sums.add(here);
      if (epoch > 0 || i > 0) steer_rate(here.surrogate.kl / size, model);
      take_steps(blocks_of(static_cast<int>(minibatch.size())), model, team);
    }
  }
  const double count = samples.count();
  report.kl = sums.surrogate.kl / count;
  report.surrogate = sums.surrogate.surrogate / count;
  report.clipped_share = sums.surrogate.clipped / count;
  report.value_loss = sums.value / count;
  report.estimator_loss = sums.estimator / count;
  report.symmetry_loss = sums.symmetry / count;
}

}  // namespace torquewright::learning
