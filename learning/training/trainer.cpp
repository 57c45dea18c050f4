// SPDX-License-Identifier: Apache-2.0
#include "learning/training/trainer.hpp"

#include <chrono>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "learning/training/acting.hpp"
#include "learning/training/copies.hpp"
#include "learning/training/judging.hpp"
#include "learning/training/learning.hpp"
#include "learning/training/options_check.hpp"
#include "learning/training/saved_state.hpp"

namespace torquewright::learning {
namespace {

using Clock = std::chrono::steady_clock;

/// Streams of random numbers for the order of samples, one for each iteration.
constexpr std::uint64_t kOrderStream = std::uint64_t{1} << 41;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

const TrainerOptions& checked(const Sizes& sizes, const TrainerOptions& options) {
  const std::string objection = objection_to(sizes, options);
  if (!objection.empty()) throw std::invalid_argument(objection);
  return options;
}

void add_totals(const Model& model, IterationReport& report) {
  constexpr double kEntropyOfOne = 1.4189385332046727;  // (1 + log(2 pi)) / 2
  report.learning_rate = model.rate;
  report.deviation = model.log_deviations.array().exp().mean();
  report.entropy =
      model.log_deviations.sum() + kEntropyOfOne * static_cast<double>(model.log_deviations.size());
}

}  // namespace

struct Trainer::State {
  State(const Sizes& all_sizes, const MakeEnvironment& make, const TrainerOptions& all_options)
      : sizes(all_sizes),
        options(checked(all_sizes, all_options)),
        team(options.threads),
        model(sizes, options),
        acting(options.copies),
        learning(options),
        samples(sizes, options.copies, options.steps_per_iteration,
                static_cast<int>(options.estimated.size())),
        policy(policy_of(model)) {
    for (int copy = 0; copy < options.copies; ++copy) {
      copies.emplace_back(make(copy), sizes, options.seed, copy, options.copies);
    }
  }

  void learn(IterationReport& report) {
    judge(options, model, team, samples);
    const Generator order(options.seed, kOrderStream + static_cast<std::uint64_t>(iteration));
    learning.run(samples, order, model, team, report);
  }

  void look_at_inputs() {
    model.actor_inputs.moments.add(samples.actor_views);
    model.critic_inputs.moments.add(samples.critic_views);
    model.actor_inputs.renew();
    model.critic_inputs.renew();
  }

  Sizes sizes;
  TrainerOptions options;
  Team team;
  Model model;
  std::vector<Copy> copies;
  Acting acting;
  Learning learning;
  Samples samples;
  Policy policy;
  std::int64_t iteration = 0;
  std::int64_t steps = 0;
};

Trainer::Trainer(const Sizes& sizes, const MakeEnvironment& make, const TrainerOptions& options)
    : state_(std::make_unique<State>(sizes, make, options)) {}

Trainer::~Trainer() = default;

IterationReport Trainer::iterate() {
  State& state = *state_;
  IterationReport report;
  const Clock::time_point start = Clock::now();
  state.acting.run(state.model, state.team, state.copies, state.samples);
  report.acting_s = seconds_since(start);
  ++state.iteration;
  state.steps += state.samples.count();
  // How inputs are seen must not change between acting and learning; so what they are usually is
  // renewed behind both, and the first iteration, which does not know it, learns nothing else.
  if (state.iteration > 1) state.learn(report);
  state.look_at_inputs();
  state.policy = policy_of(state.model);
  report.learning_s = seconds_since(start) - report.acting_s;
  report.iteration = state.iteration;
  report.steps = state.steps;
  for (const Copy& copy : state.copies) {
    report.episodes.insert(report.episodes.end(), copy.reports().begin(), copy.reports().end());
  }
  add_totals(state.model, report);
  return report;
}

const Policy& Trainer::policy() const { return state_->policy; }

void Trainer::save(std::ostream& out) const {
  SavedState saved{state_->iteration, state_->steps, state_->model, {}};
  for (Copy& copy : state_->copies) {
    saved.copies.push_back(
        {copy.generator_state(), copy.episodes_begun(), copy.actions_taken(), copy.view()});
  }
  write_state(out, fingerprint_of(state_->sizes, state_->options), saved);
}

void Trainer::restore(std::istream& in) {
  State& state = *state_;
  SavedState saved{0, 0, Model(state.sizes, state.options), {}};
  saved.copies.resize(state.copies.size());
  for (SavedCopy& copy : saved.copies) {
    copy.view = Eigen::VectorXd::Zero(state.sizes.actor_inputs + state.sizes.critic_inputs);
  }
  read_state(in, fingerprint_of(state.sizes, state.options), saved);
  for (std::size_t i = 0; i < saved.copies.size(); ++i) {
    const SavedCopy& copy = saved.copies[i];
    state.copies[i].go_on_from(copy.generator_state, copy.episodes_begun, copy.actions_taken);
    if (state.copies[i].view() != copy.view) {
      throw std::invalid_argument("environment " + std::to_string(i) +
                                  " does not go on as it had: the task is another one");
    }
  }
  state.iteration = saved.iteration;
  state.steps = saved.steps;
  state.model = std::move(saved.model);
  state.policy = policy_of(state.model);
}

}  // namespace torquewright::learning
