// SPDX-License-Identifier: Apache-2.0
// Oracles: the published recurrence of Adam in long double numbers; the direct double sum of
// generalised advantages; two passes for mean and variance; differences and quadrature.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "learning/formulas/advantages.hpp"
#include "learning/formulas/running_moments.hpp"
#include "learning/formulas/surrogate.hpp"
#include "learning/generator.hpp"
#include "learning/network/adam.hpp"

namespace torquewright::learning {
namespace {

TEST(Adam, FollowsThePublishedRecurrence) {
  Adam<double> adam(2);
  Eigen::VectorXd parameters(2);
  parameters << 1.0, -2.0;
  long double m[2] = {0, 0};
  long double v[2] = {0, 0};
  long double expected[2] = {1, -2};
  for (int t = 1; t <= 50; ++t) {
    const Eigen::Vector2d gradient(std::sin(0.3 * t), 1e-3 * t);
    adam.step(gradient, 0.01, parameters);
    for (int i = 0; i < 2; ++i) {
      const long double g = gradient(i);
      m[i] = 0.9L * m[i] + 0.1L * g;
      v[i] = 0.999L * v[i] + 0.001L * g * g;
      const long double unbiased_m = m[i] / (1.0L - std::pow(0.9L, t));
      const long double unbiased_v = v[i] / (1.0L - std::pow(0.999L, t));
      expected[i] -= 0.01L * unbiased_m / (std::sqrt(unbiased_v) + 1e-8L);
      // 50 steps, each rounded to 1e-16 of numbers of the order of 1.
      EXPECT_NEAR(parameters(i), static_cast<double>(expected[i]), 1e-14);
    }
  }
}

TEST(Advantages, AreTheDirectSumOverWhatFollowsInTheEpisode) {
  constexpr int kSteps = 30;
  constexpr double kDiscount = 0.97;
  constexpr double kLambda = 0.9;
  Generator generator(1, 0);
  Eigen::VectorXd rewards(kSteps), values(kSteps), next(kSteps), found(kSteps);
  std::vector<char> goes_on(kSteps, 1);
  for (int t = 0; t < kSteps; ++t) {
    rewards(t) = generator.normal();
    values(t) = generator.normal();
    next(t) = generator.normal();
  }
  goes_on[7] = goes_on[8] = goes_on[20] = 0;
  next(7) = 0.0;  // ended; the others were cut
  advantages_of({rewards, values, next, goes_on}, kDiscount, kLambda, found);
  for (int t = 0; t < kSteps; ++t) {
    double sum = 0.0;
    for (int later = t; later < kSteps; ++later) {
      sum += std::pow(kDiscount * kLambda, later - t) *
             (rewards(later) + kDiscount * next(later) - values(later));
      if (goes_on[static_cast<std::size_t>(later)] == 0) break;
    }
    EXPECT_NEAR(found(t), sum, 1e-13) << t;
  }
}

TEST(RunningMoments, AreThoseOfAllThatCame) {
  Eigen::MatrixXf all(2, 300);
  Generator generator(1, 0);
  for (Eigen::Index j = 0; j < all.cols(); ++j) {
    all(0, j) = static_cast<float>(1e4 + 0.1 * generator.normal());
    all(1, j) = static_cast<float>(generator.uniform());
  }
  RunningMoments moments(2);
  moments.add(all.leftCols(1));
  moments.add(all.middleCols(1, 100));
  moments.add(all.rightCols(199));
  const Eigen::MatrixXd exact = all.cast<double>();
  const Eigen::VectorXd mean = exact.rowwise().mean();
  const Eigen::VectorXd variance = (exact.colwise() - mean).rowwise().squaredNorm() / 300.0;
  EXPECT_LT((moments.mean() - mean).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_LT((moments.variance() - variance).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(moments.deviation(0.2)(0), 0.2);
}

TEST(RunningMoments, ForgetWhatIsLongAgo) {
  RunningMoments moments(1, 10.0);
  moments.add(Eigen::MatrixXf::Constant(1, 10, 100.0F));
  for (int i = 0; i < 100; ++i) moments.add(Eigen::MatrixXf::Constant(1, 10, 3.0F));
  // Each time half of the distance is left; 2^-100 of it is nothing.
  EXPECT_NEAR(moments.mean()(0), 3.0, 1e-12);
  EXPECT_NEAR(moments.variance()(0), 0.0, 1e-12);
}

/// Samples of a policy with two actions, some of which the clip leaves without a gradient.
struct SurrogateCase {
  Eigen::MatrixXf actions{2, 40}, old_means{2, 40}, means{2, 40};
  Eigen::VectorXd old_log_deviations{{-0.3, 0.2}};
  Eigen::VectorXd log_deviations{{-0.2, 0.1}};
  Eigen::VectorXf advantages{40};

  SurrogateCase() {
    Generator generator(5, 0);
    for (Eigen::Index j = 0; j < 40; ++j) {
      for (Eigen::Index i = 0; i < 2; ++i) {
        old_means(i, j) = static_cast<float>(generator.normal());
        means(i, j) = old_means(i, j) + static_cast<float>(0.2 * generator.normal());
        actions(i, j) = old_means(i, j) + static_cast<float>(generator.normal());
      }
      advantages(j) = static_cast<float>(generator.normal());
    }
  }

  SurrogateSums sums(Eigen::MatrixXf& mean_errors, Eigen::VectorXd& deviation_errors) const {
    mean_errors = Eigen::MatrixXf::Zero(2, 40);
    deviation_errors = Eigen::VectorXd::Zero(2);
    return surrogate_of({actions, old_means, old_log_deviations, advantages}, means, log_deviations,
                        0.2, 1.0, mean_errors, deviation_errors);
  }
  double surrogate() const {
    Eigen::MatrixXf mean_errors;
    Eigen::VectorXd deviation_errors;
    return sums(mean_errors, deviation_errors).surrogate;
  }
};

TEST(Surrogate, HasTheGradientOfDifferences) {
  SurrogateCase here;
  Eigen::MatrixXf mean_errors;
  Eigen::VectorXd deviation_errors;
  const SurrogateSums sums = here.sums(mean_errors, deviation_errors);
  EXPECT_GE(sums.clipped, 5.0);
  EXPECT_LT(sums.clipped, 35.0);
  const auto slope = [&](auto& number, double step) {
    const auto there = number;
    number = static_cast<std::decay_t<decltype(number)>>(there + step);
    const double above = here.surrogate();
    const double up = number;
    number = static_cast<std::decay_t<decltype(number)>>(there - step);
    const double below = here.surrogate();
    const double down = number;
    number = there;
    return (above - below) / (up - down);
  };
  for (Eigen::Index i = 0; i < 2; ++i) {
    EXPECT_NEAR(-slope(here.log_deviations(i), 1e-6), deviation_errors(i), 1e-6);
    // Means are float: the step is large, its square times a third derivative of a few is the
    // error.
    for (Eigen::Index j = 0; j < 40; ++j) {
      EXPECT_NEAR(-slope(here.means(i, j), 1e-4), mean_errors(i, j), 1e-6);
    }
  }
}

TEST(Surrogate, DivergenceIsTheIntegral) {
  Eigen::MatrixXf action = Eigen::MatrixXf::Zero(1, 1);
  const Eigen::MatrixXf old_mean = Eigen::MatrixXf::Constant(1, 1, 0.5F);
  const Eigen::MatrixXf mean = Eigen::MatrixXf::Constant(1, 1, 0.75F);
  const Eigen::VectorXd old_log = Eigen::VectorXd::Constant(1, std::log(0.5));
  const Eigen::VectorXd now_log = Eigen::VectorXd::Constant(1, std::log(0.4));
  const Eigen::VectorXf advantage = Eigen::VectorXf::Zero(1);
  Eigen::MatrixXf errors(1, 1);
  Eigen::VectorXd deviation_errors = Eigen::VectorXd::Zero(1);
  const double found = surrogate_of({action, old_mean, old_log, advantage}, mean, now_log, 0.2, 1.0,
                                    errors, deviation_errors)
                           .kl;
  const auto log_density = [](double x, double about, double deviation) {
    const double z = (x - about) / deviation;
    return -0.5 * z * z - std::log(deviation) - 0.5 * std::log(2.0 * std::numbers::pi);
  };
  double integral = 0.0;
  for (double x = -5.0; x < 6.0; x += 1e-3) {
    const double was = log_density(x, 0.5, 0.5);
    integral += 1e-3 * std::exp(was) * (was - log_density(x, 0.75, 0.4));
  }
  EXPECT_NEAR(found, integral, 1e-9);
}

TEST(LearningGenerator, HasMomentsOfItsDistributionsAndStreamsOfTheirOwn) {
  Generator generator(1, 2);
  constexpr int kCount = 200000;
  double sum = 0.0, squares = 0.0, uniform = 0.0;
  for (int i = 0; i < kCount; ++i) {
    const double drawn = generator.normal();
    sum += drawn;
    squares += drawn * drawn;
    uniform += generator.uniform();
  }
  // Four deviations of means of so many.
  EXPECT_NEAR(sum / kCount, 0.0, 4.0 / std::sqrt(kCount));
  EXPECT_NEAR(squares / kCount, 1.0, 4.0 * std::sqrt(2.0 / kCount));
  EXPECT_NEAR(uniform / kCount, 0.5, 4.0 * std::sqrt(1.0 / 12.0 / kCount));
  EXPECT_NE(Generator(1, 2).bits(), Generator(2, 1).bits());
  EXPECT_NE(Generator(1, 1).bits(), Generator(1, 0).bits());
}

}  // namespace
}  // namespace torquewright::learning
