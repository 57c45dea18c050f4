// SPDX-License-Identifier: Apache-2.0
// Oracles: central differences of the loss itself, in double numbers; Eigen's products; the policy
// as it is used, which is written apart.
#include "learning/network/network.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "learning/network/policy.hpp"
#include "learning/network/products.hpp"

namespace torquewright::learning {
namespace {

constexpr ActivationKind kKinds[] = {ActivationKind::kIdentity, ActivationKind::kRelu,
                                     ActivationKind::kLeakyRelu, ActivationKind::kElu,
                                     ActivationKind::kTanh};

Eigen::MatrixXd drawn(Eigen::Index rows, Eigen::Index columns, std::uint64_t number) {
  Generator generator(7, number);
  Eigen::MatrixXd matrix(rows, columns);
  for (double& entry : matrix.reshaped()) entry = generator.normal();
  return matrix;
}

/// Half of the squared distance of the outputs to some targets.
double loss_of(const Network<double>& network, Network<double>::Pass& pass,
               const Eigen::MatrixXd& targets) {
  return 0.5 * (network.evaluate(pass) - targets).squaredNorm();
}

TEST(NetworkGradient, IsThatOfCentralDifferencesForEveryActivation) {
  for (const ActivationKind kind : kKinds) {
    Network<double> network({{3, 6, 5, 2}, activation_of(kind)});
    Generator generator(1, 0);
    network.draw(generator, 1.0);
    Network<double>::Pass pass;
    pass.inputs = drawn(3, 4, 1);
    const Eigen::MatrixXd targets = drawn(2, 4, 2);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(network.parameters().size());
    const Eigen::MatrixXd errors = network.evaluate(pass) - targets;
    network.add_gradient(errors, pass, gradient);
    const double step = std::cbrt(2.2e-16);
    for (Eigen::Index i = 0; i < gradient.size(); ++i) {
      double& parameter = network.parameters()(i);
      const double there = parameter;
      parameter = there + step;
      const double above = loss_of(network, pass, targets);
      parameter = there - step;
      const double below = loss_of(network, pass, targets);
      parameter = there;
      // Error of the differences: step^2 times a third derivative of the order of 10.
      EXPECT_NEAR(gradient(i), (above - below) / (2.0 * step), 1e-8)
          << name_of(kind) << ", parameter " << i;
    }
  }
}

TEST(NetworkGradient, IsAddedToWhatWasThere) {
  Network<double> network({{2, 3, 1}, activation_of(ActivationKind::kTanh)});
  Generator generator(1, 0);
  network.draw(generator, 1.0);
  Network<double>::Pass pass;
  pass.inputs = drawn(2, 3, 1);
  const Eigen::MatrixXd errors = network.evaluate(pass);
  Eigen::VectorXd once = Eigen::VectorXd::Zero(network.parameters().size());
  network.add_gradient(errors, pass, once);
  Eigen::VectorXd twice = once;
  network.add_gradient(errors, pass, twice);
  EXPECT_LT((twice - 2.0 * once).norm(), 1e-14);
}

TEST(Products, OfFloatsAreThoseOfDoublesForAllSizesAboutAPanel) {
  for (const int rows : {1, 2, 8, 31, 32, 33, 70}) {
    for (const int columns : {1, 5, 12, 13, 25}) {
      for (const int inner : {1, 3, 40}) {
        const Eigen::MatrixXd a = drawn(rows, inner, 1);
        const Eigen::MatrixXd b = drawn(inner, columns, 2);
        const Eigen::MatrixXf a_float = a.cast<float>();
        const Eigen::MatrixXf b_float = b.cast<float>();
        const Eigen::MatrixXf a_turned = a_float.transpose();
        const Eigen::MatrixXf b_turned = b_float.transpose();
        const Eigen::MatrixXd exact = a_float.cast<double>() * b_float.cast<double>();
        // Each of at most 40 roundings of a sum that is below 40 in size.
        const double tolerance = 40 * 40 * 6e-8;
        Eigen::MatrixXf product;
        multiply(a_float, b_float, product);
        EXPECT_LT((product.cast<double>() - exact).cwiseAbs().maxCoeff(), tolerance);
        multiply_left_transposed(a_turned, b_float, product);
        EXPECT_LT((product.cast<double>() - exact).cwiseAbs().maxCoeff(), tolerance);
        multiply_right_transposed(a_float, b_turned, product);
        EXPECT_LT((product.cast<double>() - exact).cwiseAbs().maxCoeff(), tolerance);
      }
    }
  }
}

TEST(Products, DoNotDependOnWhatStandsBesideThem) {
  const Eigen::MatrixXf a = drawn(70, 40, 1).cast<float>();
  const Eigen::MatrixXf b = drawn(40, 25, 2).cast<float>();
  Eigen::MatrixXf all;
  multiply(a, b, all);
  Eigen::MatrixXf one;
  for (Eigen::Index j = 0; j < b.cols(); ++j) {
    multiply(a, b.col(j), one);
    EXPECT_EQ(one.col(0), all.col(j));
  }
}

TEST(PolicyEvaluation, SaysWhatTheNetworkSaidOfManyAtOnce) {
  for (const ActivationKind kind : kKinds) {
    Network<float> estimator({{4, 8, 2}, activation_of(kind)});
    Network<float> actor({{6, 16, 8, 3}, activation_of(kind)});
    Generator generator(3, 0);
    estimator.draw(generator, 1.0);
    actor.draw(generator, 1.0);
    Policy policy;
    policy.normalisation = {drawn(4, 1, 5), Eigen::Vector4d(0.5, 1.0, 2.0, 4.0)};
    policy.estimator = estimator.as_layers();
    policy.layers = actor.as_layers();
    ASSERT_EQ(objection_to(policy), "");
    PolicyEvaluation evaluation(policy);
    const Eigen::MatrixXd views = drawn(4, 9, 6);
    Network<float>::Pass guessing;
    guessing.inputs = ((views.colwise() - policy.normalisation.mean).array().colwise() /
                       policy.normalisation.deviation.array())
                          .matrix()
                          .cast<float>();
    Network<float>::Pass acting;
    acting.inputs.resize(6, 9);
    acting.inputs << guessing.inputs, estimator.evaluate(guessing);
    const Eigen::MatrixXf actions = actor.evaluate(acting);
    for (Eigen::Index j = 0; j < views.cols(); ++j) {
      // Roundings of float in three layers of numbers of the order of 1 to 10.
      EXPECT_LT((evaluation.action(views.col(j)) - actions.col(j).cast<double>()).norm(), 2e-5);
      EXPECT_LT((evaluation.guess() - acting.inputs.col(j).tail(2).cast<double>()).norm(), 1e-5);
    }
  }
}

TEST(PolicyObjection, SaysWhichSizesDoNotFit) {
  Policy policy;
  policy.normalisation = {Eigen::VectorXd::Zero(2), Eigen::VectorXd::Ones(2)};
  EXPECT_EQ(objection_to(policy), "the policy has no layer");
  policy.layers = {{Eigen::MatrixXd::Ones(1, 3), Eigen::VectorXd::Zero(1), {}}};
  EXPECT_EQ(objection_to(policy),
            "layer 1 has weights for 3 inputs, not for the 2 that it is given");
  policy.estimator = {{Eigen::MatrixXd::Ones(1, 2), Eigen::VectorXd::Zero(1), {}}};
  EXPECT_EQ(objection_to(policy), "");
  policy.normalisation.deviation(1) = 0.0;
  EXPECT_NE(objection_to(policy).find("not above 0"), std::string::npos);
}

}  // namespace
}  // namespace torquewright::learning
