// SPDX-License-Identifier: Apache-2.0
#include "learning/training/samples.hpp"

namespace torquewright::learning {

Samples::Samples(const Sizes& sizes, int copy_count, int steps_of_copy, int guessed)
    : copies(copy_count),
      steps(steps_of_copy),
      actor_views(sizes.actor_inputs, count()),
      critic_views(sizes.critic_inputs, count()),
      guesses(guessed, count()),
      means(sizes.actions, count()),
      actions(sizes.actions, count()),
      rewards(count(), sizes.heads),
      goes_on(static_cast<std::size_t>(count())),
      beyond(static_cast<std::size_t>(copies)),
      beyond_count(static_cast<std::size_t>(copies)),
      values(count(), sizes.heads),
      next_values(count(), sizes.heads),
      advantages_of_heads(count(), sizes.heads),
      advantages(count()),
      targets(sizes.heads, count()) {}

ViewBeyond& Samples::add_beyond(int copy, int sample, Eigen::Index critic_inputs) {
  const auto at = static_cast<std::size_t>(copy);
  if (beyond_count[at] == beyond[at].size()) beyond[at].emplace_back();
  ViewBeyond& view = beyond[at][beyond_count[at]++];
  view.sample = sample;
  view.critic_view.resize(critic_inputs);
  return view;
}

}  // namespace torquewright::learning
