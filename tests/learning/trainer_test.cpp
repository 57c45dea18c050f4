// SPDX-License-Identifier: Apache-2.0
// Oracles: the known best action of a bandit; Riccati's equation for a linear-quadratic task; a
// speed that is a difference of positions; a mirror that the task has.
#include "learning/training/trainer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "learning/generator.hpp"
#include "tests/learning/linear_quadratic.hpp"

namespace torquewright::learning {
namespace {

/// One action for one number seen: earns -(a - (0.7 s - 0.2))^2, and 100 whatever is done.
class Bandit : public Environment {
 public:
  void begin(std::uint64_t seed, std::uint64_t episode) override {
    s_ = 3.0 + 4.0 * Generator(seed, episode).normal();
  }
  void observe(Eigen::Ref<Eigen::VectorXd> actor,
               Eigen::Ref<Eigen::VectorXd> critic) const override {
    actor(0) = critic(0) = s_;
  }
  Outcome act(const Eigen::Ref<const Eigen::VectorXd>& action) override {
    const double off = action(0) - (0.7 * s_ - 0.2);
    return {{100.0 - off * off}, true, false};
  }

 private:
  double s_ = 0.0;
};

TrainerOptions small_options() {
  TrainerOptions options;
  options.copies = 64;
  options.steps_per_iteration = 40;
  options.minibatch = 640;
  options.actor_layers = {32, 32};
  options.critic_layers = {32, 32};
  options.estimator_layers = {32};
  options.entropy = 0.0;
  options.least_deviation = 0.05;
  options.target_kl = 0.004;
  options.first_rate = 1e-3;
  options.least_rate = 1e-5;
  options.greatest_rate = 2e-3;
  return options;
}

TEST(TrainerBandit, FindsTheBestActionForWhatItSees) {
  TrainerOptions options = small_options();
  options.actor_layers = {};
  Trainer trainer(
      {1, 1, 1, 1}, [](int) { return std::make_unique<Bandit>(); }, options);
  IterationReport report;
  for (int i = 0; i < 150; ++i) report = trainer.iterate();
  EXPECT_EQ(report.episodes.size(), 64U * 40U);
  PolicyEvaluation learned(trainer.policy());
  for (const double s : {-5.0, 0.0, 3.0, 7.0, 11.0}) {
    // A tenth of the least deviation that actions are tried with, over two deviations of s.
    EXPECT_NEAR(learned.action(Eigen::VectorXd::Constant(1, s))(0), 0.7 * s - 0.2, 0.05) << s;
  }
}

/// Cost of the learned policy over that of the best one, from a grid of states.
double cost_ratio(const LinearQuadratic& task, const Policy& policy) {
  PolicyEvaluation learned(policy);
  const Eigen::RowVector2d gain = riccati_gain(task);
  double cost = 0.0;
  double least = 0.0;
  constexpr int kSteps = 200;
  for (double position = -0.9; position < 1.0; position += 0.3) {
    for (double speed = -0.9; speed < 1.0; speed += 0.3) {
      Eigen::Vector2d x(position, speed);
      least += cost_of_gain(task, gain, x, kSteps);
      double weight = 1.0;
      for (int t = 0; t < kSteps; ++t, weight *= task.discount) {
        const double u = learned.action(x)(0);
        cost += weight * (x.dot(task.Q * x) + task.R * u * u);
        x = task.A * x + task.B * u;
      }
    }
  }
  return cost / least;
}

Policy learned(const LinearQuadratic& task, TrainerOptions options, int iterations) {
  options.discounts = {task.discount};
  Trainer trainer(sizes_of(task), environments_of(task), options);
  for (int i = 0; i < iterations; ++i) trainer.iterate();
  return trainer.policy();
}

TEST(TrainerLinearQuadratic, OracleIsTheBestOfItsNeighbours) {
  const LinearQuadratic task;
  const Eigen::RowVector2d gain = riccati_gain(task);
  const Eigen::Vector2d x(1.0, -0.5);
  const double least = cost_of_gain(task, gain, x, 1000);
  for (const double change : {0.9, 0.99, 1.01, 1.1}) {
    EXPECT_GT(cost_of_gain(task, Eigen::RowVector2d(change * gain(0), gain(1)), x, 1000), least);
    EXPECT_GT(cost_of_gain(task, Eigen::RowVector2d(gain(0), change * gain(1)), x, 1000), least);
  }
}

TEST(TrainerLinearQuadratic, CostsLittleMoreThanRiccatisSolution) {
  const LinearQuadratic task;
  // The untrained policy does nothing and costs a multiple; what is tried out has a deviation of a
  // fifth still.
  EXPECT_GT(cost_ratio(task, learned(task, small_options(), 1)), 1.5);
  const double ratio = cost_ratio(task, learned(task, small_options(), 80));
  EXPECT_GT(ratio, 1.0);
  EXPECT_LT(ratio, 1.05);
}

TEST(TrainerLinearQuadratic, TwoHeadsFindWhatOneFinds) {
  LinearQuadratic task;
  task.is_split = true;
  for (const bool is_separate : {false, true}) {
    TrainerOptions options = small_options();
    options.separate_critics = is_separate;
    EXPECT_LT(cost_ratio(task, learned(task, options, 80)), 1.05);
  }
}

TEST(TrainerLinearQuadratic, ADiscountOfItsOwnForTheHeadOfActionsChangesTheSolution) {
  LinearQuadratic task;
  task.is_split = true;
  TrainerOptions options = small_options();
  options.discounts = {0.0, task.discount};  // states of the next step count nothing: do nothing
  Trainer trainer(sizes_of(task), environments_of(task), options);
  for (int i = 0; i < 80; ++i) trainer.iterate();
  PolicyEvaluation policy(trainer.policy());
  EXPECT_NEAR(policy.action(Eigen::Vector2d(0.5, 0.5))(0), 0.0, 0.1);
}

TEST(TrainerEstimator, GuessesTheSpeedThatOnlyTheCriticSees) {
  LinearQuadratic task;
  task.hides_speed = true;
  TrainerOptions options = small_options();
  options.discounts = {task.discount};
  options.estimated = {1};
  Trainer trainer(sizes_of(task), environments_of(task), options);
  IterationReport first = trainer.iterate();
  first = trainer.iterate();
  IterationReport last = first;
  for (int i = 0; i < 60; ++i) last = trainer.iterate();
  // The speed now is that between the last two positions, but for half a step of acceleration.
  EXPECT_LT(last.estimator_loss, 0.02);
  EXPECT_GT(first.estimator_loss, 2.0 * last.estimator_loss);
  PolicyEvaluation policy(trainer.policy());
  const auto guess = [&](double position, double speed) {
    policy.action(Eigen::Vector2d(position, speed));
    return policy.guess()(0);
  };
  // Of the speed, not of the position.
  EXPECT_GT(guess(0.0, 0.5) - guess(0.0, -0.5), 0.5);
  EXPECT_LT(std::abs(guess(0.5, 0.0) - guess(-0.5, 0.0)),
            0.3 * (guess(0.0, 0.5) - guess(0.0, -0.5)));
  EXPECT_EQ(trainer.policy().estimator.size(), 2U);
  EXPECT_EQ(trainer.policy().layers.front().weights.cols(), 3);
}

/// Greatest difference between an action and the mirrored action of the mirrored view.
double asymmetry(const Policy& policy) {
  PolicyEvaluation evaluation(policy);
  double greatest = 0.0;
  for (double position = -1.0; position < 1.1; position += 0.25) {
    for (double speed = -1.0; speed < 1.1; speed += 0.25) {
      const Eigen::Vector2d x(position, speed);
      const double here = evaluation.action(x)(0);
      greatest = std::max(greatest, std::abs(here + evaluation.action(-x)(0)));
    }
  }
  return greatest;
}

TEST(TrainerSymmetry, MakesThePolicyThatOfItsMirror) {
  const LinearQuadratic task;
  TrainerOptions options = small_options();
  const double without = asymmetry(learned(task, options, 40));
  options.mirror = Mirror{{{0, 1}, {-1.0, -1.0}}, {{0}, {-1.0}}};
  options.symmetry = 10.0;
  const Policy symmetric = learned(task, options, 80);
  EXPECT_LT(asymmetry(symmetric), 0.3 * without);
  EXPECT_LT(cost_ratio(task, symmetric), 1.05);
}

TEST(TrainerOptionsCheck, SaysWhatIsWrong) {
  const LinearQuadratic task;
  const auto message = [&](const TrainerOptions& options) -> std::string {
    try {
      Trainer trainer(sizes_of(task), environments_of(task), options);
      return "";
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  TrainerOptions options;
  options.discounts = {0.9, 0.9};
  EXPECT_EQ(message(options), "there is to be one discount, or one for each head");
  options = {};
  options.estimated = {2};
  EXPECT_EQ(message(options), "the critic sees no entry 2 that could be estimated");
  options = {};
  options.mirror = Mirror{{{1, 1}, {1.0, 1.0}}, {{0}, {1.0}}};
  EXPECT_EQ(message(options), "mirroring entry 0 of the actor's view twice is to be no change");
}

/// Nothing is worth more than anything else.
class Idle : public Bandit {
 public:
  Outcome act(const Eigen::Ref<const Eigen::VectorXd>&) override { return {{0.0}, true, false}; }
};

TEST(TrainerEntropy, IsPaidForWhereNothingElseIs) {
  TrainerOptions options = small_options();
  double free = 0.0;
  for (const double price : {0.0, 1.0}) {
    options.entropy = price;
    Trainer trainer(
        {1, 1, 1, 1}, [](int) { return std::make_unique<Idle>(); }, options);
    IterationReport report;
    for (int i = 0; i < 5; ++i) report = trainer.iterate();
    if (price == 0.0) {
      free = report.deviation;
    } else {
      EXPECT_GT(report.deviation, 1.01 * free);
    }
    // Of a normal number (Cover and Thomas, Elements of Information Theory, 8.1).
    const double variance = report.deviation * report.deviation;
    EXPECT_NEAR(report.entropy, 0.5 * std::log(2.0 * M_PI * std::exp(1.0) * variance), 1e-12);
  }
}

/// Earns what is no number in its third step.
class BrokenTask : public Bandit {
 public:
  Outcome act(const Eigen::Ref<const Eigen::VectorXd>&) override {
    return {{++step_ < 3 ? 0.0 : std::nan("")}, false, false};
  }

 private:
  int step_ = 0;
};

TEST(Trainer, NamesTheEnvironmentWhoseRewardIsNoNumber) {
  Trainer trainer(
      {1, 1, 1, 1}, [](int) { return std::make_unique<BrokenTask>(); }, small_options());
  try {
    trainer.iterate();
    FAIL() << "nothing was thrown";
  } catch (const std::domain_error& error) {
    EXPECT_STREQ(error.what(),
                 "environment 0, episode 0, step 3: the reward of head 0 is not finite");
  }
}

}  // namespace
}  // namespace torquewright::learning
