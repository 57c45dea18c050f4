// SPDX-License-Identifier: Apache-2.0
#include "learning/training/block.hpp"

namespace torquewright::learning {
namespace {

void write_mirrored(const MirroredVector& mirror, const Eigen::Ref<const Eigen::VectorXf>& vector,
                    Eigen::VectorXf& mirrored) {
  mirrored.resize(vector.size());
  for (Eigen::Index i = 0; i < vector.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    mirrored(i) = static_cast<float>(mirror.sign[at]) * vector(mirror.from[at]);
  }
}

/// Shows the actor the block's samples and, behind them, what their mirrored views are.
void show_actor(const BlockTask& task, std::span<const int> samples, BlockRoom& room) {
  const auto count = static_cast<Eigen::Index>(samples.size());
  const Eigen::Index inputs = task.samples.actor_views.rows();
  const Eigen::Index guesses = task.samples.guesses.rows();
  const bool is_mirrored = task.options.mirror.has_value();
  Eigen::MatrixXf& shown = room.actor.inputs;
  shown.resize(inputs + guesses, is_mirrored ? 2 * count : count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const int sample = samples[static_cast<std::size_t>(i)];
    task.model.actor_inputs.show(task.samples.actor_views.col(sample), shown.col(i).head(inputs));
    shown.col(i).tail(guesses) = task.samples.guesses.col(sample);
    if (!is_mirrored) continue;
    write_mirrored(task.options.mirror->actor, task.samples.actor_views.col(sample), room.mirrored);
    task.model.actor_inputs.show(room.mirrored, shown.col(count + i).head(inputs));
  }
  if (!is_mirrored || !task.model.estimator) return;
  room.mirrored_estimator.inputs = shown.topRightCorner(inputs, count);
  shown.bottomRightCorner(guesses, count) =
      task.model.estimator->network.evaluate(room.mirrored_estimator);
}

/// Adds the errors of weight |action - mirrored action of the mirrored|^2 / actions.
void add_symmetry_errors(const BlockTask& task, const Eigen::MatrixXf& means, Eigen::Index count,
                         BlockRoom& room, LossSums& sums) {
  const MirroredVector& mirror = task.options.mirror->action;
  const double share = 1.0 / static_cast<double>(means.rows());
  for (Eigen::Index j = 0; j < count; ++j) {
    for (Eigen::Index i = 0; i < means.rows(); ++i) {
      const int from = mirror.from[static_cast<std::size_t>(i)];
      const double sign = mirror.sign[static_cast<std::size_t>(i)];
      const double difference = means(i, j) - sign * means(from, count + j);
      sums.symmetry += share * difference * difference;
      const double slope = 2.0 * share * task.weight * task.options.symmetry * difference;
      room.errors(i, j) += static_cast<float>(slope);
      room.errors(from, count + j) -= static_cast<float>(sign * slope);
    }
  }
}

void actor_gradient(const BlockTask& task, std::span<const int> samples, BlockRoom& room,
                    BlockGradient& gradient) {
  const auto count = static_cast<Eigen::Index>(samples.size());
  show_actor(task, samples, room);
  const Eigen::MatrixXf& means = task.model.actor.network.evaluate(room.actor);
  room.actions.resize(means.rows(), count);
  room.old_means.resize(means.rows(), count);
  room.advantages.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const int sample = samples[static_cast<std::size_t>(i)];
    room.actions.col(i) = task.samples.actions.col(sample);
    room.old_means.col(i) = task.samples.means.col(sample);
    room.advantages(i) = task.samples.advantages(sample);
  }
  room.errors.setZero(means.rows(), means.cols());
  gradient.log_deviations.setZero();
  gradient.sums.surrogate =
      surrogate_of({room.actions, room.old_means, task.old_log_deviations, room.advantages},
                   means.leftCols(count), task.model.log_deviations, task.options.clip, task.weight,
                   room.errors.leftCols(count), gradient.log_deviations);
  if (task.options.mirror) add_symmetry_errors(task, means, count, room, gradient.sums);
  gradient.actor.setZero();
  task.model.actor.network.add_gradient(room.errors, room.actor, gradient.actor);
}

void show_critics(const BlockTask& task, std::span<const int> samples, Eigen::MatrixXf& shown) {
  shown.resize(task.samples.critic_views.rows(), static_cast<Eigen::Index>(samples.size()));
  for (Eigen::Index i = 0; i < shown.cols(); ++i) {
    task.model.critic_inputs.show(
        task.samples.critic_views.col(samples[static_cast<std::size_t>(i)]), shown.col(i));
  }
}

void critics_gradient(const BlockTask& task, std::span<const int> samples, BlockRoom& room,
                      BlockGradient& gradient) {
  const auto heads = static_cast<int>(task.samples.targets.rows());
  show_critics(task, samples, room.critics.front().inputs);
  for (std::size_t critic = 0; critic < task.model.critics.size(); ++critic) {
    if (critic > 0) room.critics[critic].inputs = room.critics.front().inputs;
    const Network<float>& network = task.model.critics[critic].network;
    room.errors = network.evaluate(room.critics[critic]);
    for (int head = 0; head < heads; ++head) {
      if (task.model.critic_of(head) != static_cast<int>(critic)) continue;
      for (Eigen::Index i = 0; i < room.errors.cols(); ++i) {
        room.errors(task.model.output_of(head), i) -=
            task.samples.targets(head, samples[static_cast<std::size_t>(i)]);
      }
    }
    gradient.sums.value += room.errors.cast<double>().squaredNorm() / heads;
    room.errors *= static_cast<float>(2.0 * task.weight / heads);
    gradient.critics[critic].setZero();
    network.add_gradient(room.errors, room.critics[critic], gradient.critics[critic]);
  }
}

void estimator_gradient(const BlockTask& task, std::span<const int> samples, BlockRoom& room,
                        BlockGradient& gradient) {
  if (!task.model.estimator) return;
  const std::vector<int>& estimated = task.options.estimated;
  const auto count = static_cast<Eigen::Index>(samples.size());
  room.estimator.inputs = room.actor.inputs.topLeftCorner(task.samples.actor_views.rows(), count);
  const Network<float>& network = task.model.estimator->network;
  room.errors = network.evaluate(room.estimator);
  for (Eigen::Index i = 0; i < room.errors.rows(); ++i) {
    const int entry = estimated[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < count; ++j) {
      room.errors(i, j) -= room.critics.front().inputs(entry, j);
    }
  }
  const auto guesses = static_cast<double>(estimated.size());
  gradient.sums.estimator += room.errors.cast<double>().squaredNorm() / guesses;
  room.errors *= static_cast<float>(2.0 * task.weight / guesses);
  gradient.estimator.setZero();
  network.add_gradient(room.errors, room.estimator, gradient.estimator);
}

}  // namespace

void LossSums::add(const LossSums& more) {
  surrogate.surrogate += more.surrogate.surrogate;
  surrogate.kl += more.surrogate.kl;
  surrogate.clipped += more.surrogate.clipped;
  value += more.value;
  estimator += more.estimator;
  symmetry += more.symmetry;
}

BlockGradient::BlockGradient(const Model& model)
    : actor(Eigen::VectorXf::Zero(model.actor.network.parameters().size())),
      log_deviations(Eigen::VectorXd::Zero(model.log_deviations.size())) {
  for (const Learner& critic : model.critics) {
    critics.push_back(Eigen::VectorXf::Zero(critic.network.parameters().size()));
  }
  if (model.estimator) {
    estimator = Eigen::VectorXf::Zero(model.estimator->network.parameters().size());
  }
}

BlockRoom::BlockRoom(const Model& model) : critics(model.critics.size()) {}

void block_gradient(const BlockTask& task, std::span<const int> samples, BlockRoom& room,
                    BlockGradient& gradient) {
  gradient.sums = {};
  actor_gradient(task, samples, room, gradient);
  critics_gradient(task, samples, room, gradient);
  estimator_gradient(task, samples, room, gradient);
}

}  // namespace torquewright::learning
