// SPDX-License-Identifier: Apache-2.0
// Oracles: the critic's own answer for each view, asked one by one, and the advantages' formula
// written out for three steps; values before a change of their scale.
#include "learning/training/judging.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "learning/training/copies.hpp"
#include "tests/learning/linear_quadratic.hpp"

namespace torquewright::learning {
namespace {

constexpr Sizes kJudged{2, 2, 1, 2};

TrainerOptions judged_options(bool is_separate) {
  TrainerOptions options;
  options.copies = 2;
  options.steps_per_iteration = 3;
  options.critic_layers = {8};
  options.actor_layers = {4};
  options.discounts = {0.9, 0.5};
  options.separate_critics = is_separate;
  return options;
}

/// Copy 0: cut behind its second step, goes on behind its third; copy 1: ended behind its first.
Samples judged_samples() {
  Samples samples(kJudged, 2, 3, 0);
  Generator generator(4, 0);
  for (float& entry : samples.critic_views.reshaped()) {
    entry = static_cast<float>(generator.normal());
  }
  for (double& reward : samples.rewards.reshaped()) reward = generator.normal();
  samples.goes_on = {1, 0, 1, 0, 1, 1};
  for (const int sample : {1, 2, 5}) {
    ViewBeyond& beyond = samples.add_beyond(sample < 3 ? 0 : 1, sample, 2);
    beyond.critic_view = Eigen::Vector2f(0.1F * static_cast<float>(sample), -1.0F);
  }
  return samples;
}

/// What the critics say of one view, in units of rewards.
Eigen::Vector2d value_of_view(const Model& model, const ValueScale& scale,
                              const Eigen::VectorXf& view) {
  Network<float>::Pass pass;
  pass.inputs = view;
  Eigen::MatrixXd values(1, 2);
  write_values(model, scale, pass, values);
  return values.row(0).transpose();
}

TEST(Judging, TakesTheValueBeyondWhereAnEpisodeIsCutAndNoneWhereItEnds) {
  for (const bool is_separate : {false, true}) {
    const TrainerOptions options = judged_options(is_separate);
    Model model(kJudged, options);
    Team team(2);
    Samples samples = judged_samples();
    const Model before = model;
    judge(options, model, team, samples);
    const auto value = [&](const Eigen::VectorXf& view) {
      return value_of_view(before, value_scale_of(before), view);
    };
    const auto view = [&](int sample) { return value(samples.critic_views.col(sample)); };
    const auto beyond = [&](int sample) {
      return value(Eigen::Vector2f(0.1F * static_cast<float>(sample), -1.0F));
    };
    for (Eigen::Index head = 0; head < 2; ++head) {
      const double discount = options.discounts[static_cast<std::size_t>(head)];
      const auto surprise = [&](int sample, double next) {
        return samples.rewards(sample, head) + discount * next - view(sample)(head);
      };
      const double fade = discount * options.lambda;
      const double cut = surprise(1, beyond(1)(head));
      const double last = surprise(5, beyond(5)(head));
      const double expected[] = {surprise(0, view(1)(head)) + fade * cut,
                                 cut,
                                 surprise(2, beyond(2)(head)),
                                 surprise(3, 0.0),
                                 surprise(4, view(5)(head)) + fade * last,
                                 last};
      for (int sample = 0; sample < 6; ++sample) {
        // Floats of a network whose sums do not depend on what stands beside them.
        EXPECT_NEAR(samples.advantages_of_heads(sample, head), expected[sample], 1e-6);
      }
    }
    EXPECT_NEAR(samples.advantages.mean(), 0.0, 1e-6);
    EXPECT_NEAR(samples.advantages.squaredNorm() / 6.0, 1.0, 1e-5);
    // Both heads count alike in the sum.
    const Eigen::VectorXd sum = samples.advantages_of_heads.rowwise().sum();
    EXPECT_NEAR((samples.advantages(0) - samples.advantages(1)) /
                    (samples.advantages(2) - samples.advantages(3)),
                (sum(0) - sum(1)) / (sum(2) - sum(3)), 1e-4);
  }
}

TEST(Copy, SeesWhatLiesBeyondACutBeforeTheNextEpisodeBegins) {
  LinearQuadratic task;
  task.steps = 2;
  const Sizes sizes = sizes_of(task);
  Samples samples(sizes, 1, 3, 0);
  samples.beyond_count = {0};
  samples.means.setZero();
  Copy copy(environments_of(task)(0), sizes, 1, 0, 1);
  for (int sample = 0; sample < 3; ++sample) {
    copy.observe(sample, samples);
    copy.act(sample, sample == 2, Eigen::VectorXd::Zero(1), samples);
  }
  // The second step led to A A x, the third to A of the next episode's state.
  ASSERT_EQ(samples.beyond_count[0], 2U);
  const Eigen::Vector2d second = task.A * task.A * samples.critic_views.col(0).cast<double>();
  const Eigen::Vector2d last = task.A * samples.critic_views.col(2).cast<double>();
  EXPECT_LT((samples.beyond[0][0].critic_view.cast<double>() - second).norm(), 1e-6);
  EXPECT_LT((samples.beyond[0][1].critic_view.cast<double>() - last).norm(), 1e-6);
  EXPECT_EQ(samples.beyond[0][0].sample, 1);
  EXPECT_EQ(samples.goes_on, (std::vector<char>{1, 0, 1}));
  ASSERT_EQ(copy.reports().size(), 1U);
  EXPECT_TRUE(copy.reports()[0].was_cut);
  EXPECT_EQ(copy.reports()[0].steps, 2);
}

TEST(ValueScale, ChangesNoValue) {
  Model model(kJudged, judged_options(false));
  const Eigen::Vector2f view(0.3F, -0.4F);
  const Eigen::Vector2d before = value_of_view(model, value_scale_of(model), view);
  Eigen::MatrixXf returns(2, 3);
  returns << 100.0F, 200.0F, 330.0F, -3.0F, -2.0F, 5.0F;
  renew_value_scale(returns, model);
  EXPECT_NEAR(value_scale_of(model).mean(0), 210.0, 1e-4);
  EXPECT_GT(value_scale_of(model).deviation(0), 90.0);
  const Eigen::Vector2d after = value_of_view(model, value_scale_of(model), view);
  // Floats of numbers of the order of 200.
  EXPECT_LT((after - before).cwiseAbs().maxCoeff(), 1e-4);
}

}  // namespace
}  // namespace torquewright::learning
