// SPDX-License-Identifier: Apache-2.0
// Oracle: the bytes of another run, with other threads, or cut in two.
#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>
#include <string>

#include "learning/training/trainer.hpp"
#include "tests/learning/linear_quadratic.hpp"

namespace torquewright::learning {
namespace {

/// Everything at once: two heads, an estimator, a mirror, episodes that outlast iterations, numbers
/// of samples that no block divides.
TrainerOptions options_of_all() {
  TrainerOptions options;
  options.copies = 29;
  options.steps_per_iteration = 23;
  options.minibatch = 300;
  options.actor_layers = {16, 8};
  options.critic_layers = {16};
  options.estimator_layers = {8};
  options.estimated = {1};
  options.discounts = {0.95, 0.9};
  options.mirror = Mirror{{{0, 1}, {-1.0, -1.0}}, {{0}, {-1.0}}};
  return options;
}

LinearQuadratic task_of_all() {
  LinearQuadratic task;
  task.is_split = true;
  task.hides_speed = true;
  return task;
}

Trainer trainer_of(const TrainerOptions& options) {
  return {sizes_of(task_of_all()), environments_of(task_of_all()), options};
}

std::string state_of(const Trainer& trainer) {
  std::ostringstream out;
  trainer.save(out);
  return out.str();
}

TEST(TrainerSameBytes, ForAnyNumberOfThreads) {
  std::string first;
  for (const int threads : {1, 2, 3}) {
    TrainerOptions options = options_of_all();
    options.threads = threads;
    Trainer trainer = trainer_of(options);
    for (int i = 0; i < 5; ++i) trainer.iterate();
    const std::string state = state_of(trainer);
    if (first.empty()) first = state;
    EXPECT_EQ(state == first, true) << threads << " threads";
  }
}

TEST(TrainerSameBytes, NotForAnotherSeed) {
  TrainerOptions options = options_of_all();
  Trainer one = trainer_of(options);
  options.seed = 2;
  Trainer other = trainer_of(options);
  one.iterate();
  other.iterate();
  EXPECT_NE(one.policy().layers.front().weights, other.policy().layers.front().weights);
}

TEST(TrainerSameBytes, WhenItGoesOnInAnotherProcess) {
  TrainerOptions options = options_of_all();
  Trainer whole = trainer_of(options);
  for (int i = 0; i < 6; ++i) whole.iterate();
  for (const int cut : {0, 1, 3}) {
    Trainer before = trainer_of(options);
    for (int i = 0; i < cut; ++i) before.iterate();
    options.threads = 2;
    Trainer after = trainer_of(options);
    std::istringstream in(state_of(before));
    after.restore(in);
    EXPECT_EQ(state_of(after) == state_of(before), true) << "cut after " << cut;
    for (int i = cut; i < 6; ++i) after.iterate();
    EXPECT_EQ(state_of(after) == state_of(whole), true) << "cut after " << cut;
  }
}

std::string refusal_of(const std::string& state, const TrainerOptions& options,
                       const LinearQuadratic& task) {
  Trainer trainer(sizes_of(task), environments_of(task), options);
  std::istringstream in(state);
  try {
    trainer.restore(in);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(TrainerRestore, RefusesWhatIsNotItsOwn) {
  TrainerOptions options = options_of_all();
  const LinearQuadratic task = task_of_all();
  Trainer trainer = trainer_of(options);
  trainer.iterate();
  const std::string state = state_of(trainer);
  EXPECT_EQ(refusal_of(state, options, task), "");
  EXPECT_EQ(refusal_of("", options, task), "this is no training state that this version wrote");
  EXPECT_EQ(refusal_of(state.substr(0, state.size() - 1), options, task),
            "the training state ends too early");
  EXPECT_EQ(refusal_of(state + "x", options, task), "the training state goes on behind its end");
  LinearQuadratic other = task;
  other.A(0, 1) = 0.2;
  EXPECT_EQ(refusal_of(state, options, other),
            "environment 0 does not go on as it had: the task is another one");
  options.clip = 0.3;
  EXPECT_EQ(refusal_of(state, options, task),
            "the training state is one of other sizes, seed or options");
}

}  // namespace
}  // namespace torquewright::learning
