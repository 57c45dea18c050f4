// SPDX-License-Identifier: Apache-2.0
#include "learning/training/copies.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace torquewright::learning {

Copy::Copy(std::unique_ptr<Environment> environment, const Sizes& sizes, std::uint64_t seed,
           int number, int copies)
    : environment_(std::move(environment)),
      seed_(seed),
      number_(number),
      copies_(copies),
      generator_(seed, static_cast<std::uint64_t>(number)),
      actor_view_(Eigen::VectorXd::Zero(sizes.actor_inputs)),
      critic_view_(Eigen::VectorXd::Zero(sizes.critic_inputs)),
      action_(Eigen::VectorXd::Zero(sizes.actions)) {
  report_.returns.assign(static_cast<std::size_t>(sizes.heads), 0.0);
}

std::string Copy::where() const {
  return "environment " + std::to_string(number_) + ", episode " + std::to_string(report_.episode) +
         ", step " + std::to_string(report_.steps);
}

void Copy::begin() {
  report_.copy = number_;
  report_.episode =
      begun_ * static_cast<std::uint64_t>(copies_) + static_cast<std::uint64_t>(number_);
  report_.steps = 0;
  report_.was_cut = false;
  std::fill(report_.returns.begin(), report_.returns.end(), 0.0);
  actions_taken_.clear();
  ++begun_;
  environment_->begin(seed_, report_.episode);
}

void Copy::look() {
  environment_->observe(actor_view_, critic_view_);
  if (actor_view_.allFinite() && critic_view_.allFinite()) return;
  throw std::domain_error(where() + ": an observation is not finite");
}

void Copy::observe(int sample, Samples& samples) {
  if (begun_ == 0) begin();
  look();
  samples.actor_views.col(sample) = actor_view_.cast<float>();
  samples.critic_views.col(sample) = critic_view_.cast<float>();
}

Outcome Copy::do_action(const Eigen::Ref<const Eigen::VectorXf>& action) {
  action_ = action.cast<double>();
  actions_taken_.insert(actions_taken_.end(), action.begin(), action.end());
  Outcome outcome = environment_->act(action_);
  ++report_.steps;
  if (outcome.rewards.size() != report_.returns.size()) {
    throw std::domain_error(where() + ": " + std::to_string(outcome.rewards.size()) +
                            " rewards, where there are " + std::to_string(report_.returns.size()) +
                            " heads");
  }
  for (std::size_t head = 0; head < outcome.rewards.size(); ++head) {
    if (!std::isfinite(outcome.rewards[head])) {
      throw std::domain_error(where() + ": the reward of head " + std::to_string(head) +
                              " is not finite");
    }
    report_.returns[head] += outcome.rewards[head];
  }
  return outcome;
}

void Copy::act(int sample, bool is_last, const Eigen::VectorXd& deviations, Samples& samples) {
  for (Eigen::Index i = 0; i < deviations.size(); ++i) {
    const double drawn = samples.means(i, sample) + deviations(i) * generator_.normal();
    samples.actions(i, sample) = static_cast<float>(drawn);
  }
  const Outcome outcome = do_action(samples.actions.col(sample));
  for (std::size_t head = 0; head < outcome.rewards.size(); ++head) {
    samples.rewards(sample, static_cast<Eigen::Index>(head)) = outcome.rewards[head];
  }
  const bool is_over = outcome.ended || outcome.cut;
  samples.goes_on[static_cast<std::size_t>(sample)] = is_over ? 0 : 1;
  if (!outcome.ended && (outcome.cut || is_last)) {
    look();
    samples.add_beyond(number_, sample, critic_view_.size()).critic_view =
        critic_view_.cast<float>();
  }
  if (!is_over) return;
  report_.was_cut = !outcome.ended;
  reports_.push_back(report_);
  begin();
}

Eigen::VectorXd Copy::view() {
  Eigen::VectorXd both(actor_view_.size() + critic_view_.size());
  if (begun_ > 0) look();
  both << actor_view_, critic_view_;
  return both;
}

void Copy::go_on_from(std::uint64_t generator_state, std::uint64_t episodes_begun,
                      const std::vector<float>& actions_taken) {
  generator_.set_state(generator_state);
  reports_.clear();
  begun_ = episodes_begun;
  if (begun_ == 0) return;
  --begun_;
  begin();
  const auto size = static_cast<std::size_t>(action_.size());
  for (std::size_t at = 0; at + size <= actions_taken.size(); at += size) {
    do_action(Eigen::Map<const Eigen::VectorXf>(actions_taken.data() + at, action_.size()));
  }
}

}  // namespace torquewright::learning
