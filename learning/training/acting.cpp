// SPDX-License-Identifier: Apache-2.0
#include "learning/training/acting.hpp"

#include <algorithm>

namespace torquewright::learning {
namespace {

/// Copies of a group: as many columns as the widest product takes at once.
constexpr int kMostOfGroup = 12;

}  // namespace

Acting::Acting(int copies) {
  int count = (copies + kMostOfGroup - 1) / kMostOfGroup;
  if (count > 1) count = std::min(copies, count + count % 2);  // two threads share them evenly
  for (int i = 0; i < count; ++i) {
    const int first = i * copies / count;
    groups_.push_back({first, (i + 1) * copies / count - first, {}, {}});
  }
}

void Acting::run(const Model& model, Team& team, std::vector<Copy>& copies, Samples& samples) {
  std::fill(samples.beyond_count.begin(), samples.beyond_count.end(), 0);
  for (Copy& copy : copies) copy.forget_reports();
  team.run(static_cast<int>(groups_.size()), [&](int number, int) {
    run_group(model, groups_[static_cast<std::size_t>(number)], copies, samples);
  });
}

void Acting::run_group(const Model& model, Group& group, std::vector<Copy>& copies,
                       Samples& samples) {
  const Eigen::VectorXd deviations = model.log_deviations.array().exp();
  const Eigen::Index inputs = samples.actor_views.rows();
  const Eigen::Index guesses = samples.guesses.rows();
  group.actor.inputs.resize(inputs + guesses, group.count);
  for (int t = 0; t < samples.steps; ++t) {
    const auto sample_of = [&](int i) { return (group.first + i) * samples.steps + t; };
    const auto copy_of = [&](int i) -> Copy& {
      return copies[static_cast<std::size_t>(group.first + i)];
    };
    for (int i = 0; i < group.count; ++i) {
      copy_of(i).observe(sample_of(i), samples);
      model.actor_inputs.show(samples.actor_views.col(sample_of(i)),
                              group.actor.inputs.col(i).head(inputs));
    }
    if (model.estimator) {
      group.estimator.inputs = group.actor.inputs.topRows(inputs);
      const auto& guessed = model.estimator->network.evaluate(group.estimator);
      group.actor.inputs.bottomRows(guesses) = guessed;
      for (int i = 0; i < group.count; ++i) samples.guesses.col(sample_of(i)) = guessed.col(i);
    }
    const auto& means = model.actor.network.evaluate(group.actor);
    for (int i = 0; i < group.count; ++i) {
      samples.means.col(sample_of(i)) = means.col(i);
      copy_of(i).act(sample_of(i), t + 1 == samples.steps, deviations, samples);
    }
  }
}

}  // namespace torquewright::learning
