// SPDX-License-Identifier: Apache-2.0
#include "identification/acceptance.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <random>

namespace torquewright::identification::acceptance_test {
namespace {

constexpr Eigen::Index kRows = 30, kBlocks = 24;
constexpr std::size_t kFolds = 4;
constexpr double kRoundOff = 1e-9;

/// Two columns and a target that holds both.
struct Made {
  Eigen::MatrixXd rows{kRows * kBlocks, 3};
  Gram gram;
  Dictionary dictionary;
  std::vector<std::size_t> folds;
};

Made make() {
  Made made;
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  for (Eigen::Index i = 0; i < made.rows.rows(); ++i) {
    const double a = normal(random), b = normal(random);
    made.rows.row(i) << a, b, 1.5 * a + 0.4 * b + normal(random);
  }
  made.gram.noise = Eigen::MatrixXd::Zero(3, 3);
  made.gram.is_usable = {true, true, true};
  made.gram.samples = static_cast<double>(made.rows.rows());
  for (Eigen::Index b = 0; b < kBlocks; ++b) {
    const Eigen::MatrixXd part = made.rows.middleRows(b * kRows, kRows);
    made.gram.blocks.push_back(
        {0, static_cast<double>(kRows), Eigen::MatrixXd(part.transpose() * part)});
    made.folds.push_back(static_cast<std::size_t>(b) / (kBlocks / kFolds));
  }
  made.dictionary.columns.resize(2);
  for (std::size_t c = 0; c < 2; ++c) {
    Variant variant;
    variant.coefficients = {{{{c, 1.0}}, -10.0, 10.0}};
    made.dictionary.variants.push_back(variant);
  }
  return made;
}

/// Residuals of every row by a least-squares fit (QR) to the rows of the other folds.
Eigen::VectorXd left_out_residuals(const Made& made, Eigen::Index columns) {
  Eigen::VectorXd residual(made.rows.rows());
  for (std::size_t fold = 0; fold < kFolds; ++fold) {
    std::vector<Eigen::Index> seen, left;
    for (Eigen::Index i = 0; i < made.rows.rows(); ++i) {
      (made.folds[static_cast<std::size_t>(i / kRows)] == fold ? left : seen).push_back(i);
    }
    const Eigen::MatrixXd train = made.rows(seen, Eigen::all), test = made.rows(left, Eigen::all);
    const Eigen::VectorXd values =
        train.leftCols(columns).colPivHouseholderQr().solve(train.col(2));
    residual(left) = test.col(2) - test.leftCols(columns) * values;
  }
  return residual;
}

// Oracle: independent method. Section 4 rule 2 of the derivation on the rows themselves: d_b, D_b
// and their spread, with the correlation of neighbouring blocks within runs.
TEST(Acceptance, GainEqualsThatOfTheRowsThemselves) {
  const Made made = make();
  const Fitter fitter(made.gram, made.dictionary, made.folds, {});
  const Gain gain = gain_of(fitter, fitter.fit({0}), fitter.fit({0, 1}));
  const Eigen::VectorXd one = left_out_residuals(made, 1), both = left_out_residuals(made, 2);
  std::vector<double> rest;
  double total = 0.0, products = 0.0, squares = 0.0;
  for (Eigen::Index b = 0; b < kBlocks; ++b) {
    const auto first = one.segment(b * kRows, kRows), second = both.segment(b * kRows, kRows);
    const double less = first.squaredNorm() - second.squaredNorm();
    total += less;
    rest.push_back(less - (first - second).squaredNorm());
  }
  for (std::size_t b = 0; b < rest.size(); ++b) {
    squares += rest[b] * rest[b];
    if (b > 0 && made.folds[b] == made.folds[b - 1]) products += rest[b] * rest[b - 1];
  }
  const double rho = std::max(0.0, products / squares);
  const double error = std::sqrt(squares * (1.0 + rho) / (1.0 - rho));
  EXPECT_NEAR(gain.loss, total, kRoundOff * one.squaredNorm());
  EXPECT_NEAR(gain.error, error, kRoundOff * error);
  EXPECT_NEAR(gain.t, total / error, kRoundOff * total / error);
  EXPECT_NEAR(gain.share, total / one.squaredNorm(), kRoundOff);
}

/// Passes every rule by a little.
Gain good() {
  Gain gain;
  gain.loss = 1.0;
  gain.t = 3.01;
  gain.share = 0.0801;
  gain.folds = 5;
  gain.folds_better = 2;
  return gain;
}

Fit valid() {
  Fit fit;
  fit.is_valid = true;
  return fit;
}

// Oracle: the rules as docs/derivations/identification.md section 4 states them, each broken alone.
TEST(Acceptance, ObjectsToEachRuleThatIsBroken) {
  EXPECT_EQ(objection(valid(), good()), "");
  EXPECT_NE(objection({}, good()).find("not determined"), std::string::npos);
  const auto broken = [](auto change) {
    Gain gain = good();
    change(gain);
    return objection(valid(), gain);
  };
  EXPECT_NE(broken([](Gain& g) { g.loss = -0.1; }).find("raises the error"), std::string::npos);
  EXPECT_NE(broken([](Gain& g) { g.t = 2.99; }).find("3.0 standard errors"), std::string::npos);
  EXPECT_NE(broken([](Gain& g) { g.share = 0.079; }).find("7.9 %"), std::string::npos);
  EXPECT_NE(broken([](Gain& g) { g.folds_better = 1; }).find("1 of 5 runs; 2 are needed"),
            std::string::npos);
  EXPECT_NE(broken([](Gain& g) { g.folds_worse = 1; }).find("makes 1 of 5"), std::string::npos);
}

// 40 % of ten runs are four; one of six runs or more may get worse.
TEST(Acceptance, AsksForMoreRunsWhereThereAreMore) {
  Gain gain = good();
  gain.folds = 10;
  gain.folds_better = 3;
  EXPECT_NE(objection(valid(), gain).find("4 are needed"), std::string::npos);
  gain.folds_better = 4;
  gain.folds_worse = 1;
  EXPECT_EQ(objection(valid(), gain), "");
  gain.folds_worse = 2;
  EXPECT_NE(objection(valid(), gain), "");
}

}  // namespace
}  // namespace torquewright::identification::acceptance_test
