// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <random>

#include "identification/model.hpp"

namespace torquewright::identification {
namespace {

constexpr Eigen::Index kColumns = 3, kRowsPerBlock = 40, kBlocks = 12;
constexpr std::size_t kFolds = 4;
constexpr double kRoundOff = 1e-10;  ///< Normal equations of well-conditioned columns.

/// Random columns, and a target that two of them explain up to noise.
Eigen::MatrixXd random_rows(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd rows(kRowsPerBlock * kBlocks, kColumns + 1);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    for (Eigen::Index c = 0; c < kColumns; ++c) rows(i, c) = normal(random);
    rows(i, kColumns) = 2.0 * rows(i, 0) - 0.7 * rows(i, 2) + 0.3 * normal(random);
  }
  return rows;
}

Gram gram_of(const Eigen::MatrixXd& rows) {
  Gram gram;
  gram.noise = Eigen::MatrixXd::Zero(rows.cols(), rows.cols());
  gram.is_usable.assign(static_cast<std::size_t>(rows.cols()), true);
  gram.samples = static_cast<double>(rows.rows());
  for (Eigen::Index b = 0; b < kBlocks; ++b) {
    const Eigen::MatrixXd part = rows.middleRows(b * kRowsPerBlock, kRowsPerBlock);
    gram.blocks.push_back(
        {0, static_cast<double>(kRowsPerBlock), Eigen::MatrixXd(part.transpose() * part)});
  }
  return gram;
}

/// One variant for each column.
Dictionary dictionary_of() {
  Dictionary dictionary;
  dictionary.columns.resize(kColumns);
  for (std::size_t c = 0; c < kColumns; ++c) {
    Variant variant;
    variant.effect = std::to_string(c);
    variant.coefficients = {{{{c, 1.0}}, -10.0, 10.0}};
    dictionary.variants.push_back(variant);
  }
  return dictionary;
}

std::vector<std::size_t> folds_of() {
  std::vector<std::size_t> folds;
  for (std::size_t b = 0; b < kBlocks; ++b) folds.push_back(b % kFolds);
  return folds;
}

// Oracle: independent method. Eigen's QR on the rows themselves, all but one fold's; the loss of
// each block by the residuals of its own rows.
TEST(Fitter, EqualsAFitToTheRowsWithEachFoldLeftOut) {
  const Eigen::MatrixXd rows = random_rows(1);
  const Gram gram = gram_of(rows);
  const Dictionary dictionary = dictionary_of();
  const Fit fit = Fitter(gram, dictionary, folds_of(), {}).fit({0, 1, 2});
  ASSERT_TRUE(fit.is_valid);
  const Eigen::VectorXd whole =
      rows.leftCols(kColumns).colPivHouseholderQr().solve(rows.col(kColumns));
  EXPECT_LT((fit.values - whole).norm(), kRoundOff);
  double loss = 0.0;
  for (std::size_t fold = 0; fold < kFolds; ++fold) {
    std::vector<Eigen::Index> seen, left;
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      (static_cast<std::size_t>(i / kRowsPerBlock) % kFolds == fold ? left : seen).push_back(i);
    }
    const Eigen::MatrixXd train = rows(seen, Eigen::all), test = rows(left, Eigen::all);
    const Eigen::VectorXd values =
        train.leftCols(kColumns).colPivHouseholderQr().solve(train.col(kColumns));
    EXPECT_LT((fit.left_out[fold] - values).norm(), kRoundOff);
    loss += (test.col(kColumns) - test.leftCols(kColumns) * values).squaredNorm();
  }
  EXPECT_NEAR(fit.loss, loss, kRoundOff * rows.col(kColumns).squaredNorm());
}

// Oracle: closed form. y = 2 x, x measured with noise of half its variance: plain least squares
// finds 2 / 1.5; with the noise's product subtracted, 2 up to its standard error. The score's
// variance per sample is 4 (s + 2 s^2) with s = 0.5, so that error is sqrt(4 / 48000), below
// 0.0092. Five of those.
TEST(Fitter, IsUnbiasedWhereTheNoiseOfAColumnIsSubtracted) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  Gram gram;
  gram.is_usable = {true, true};
  gram.noise = Eigen::MatrixXd::Zero(2, 2);
  const double many = 4000.0, noise = 0.5;
  for (Eigen::Index b = 0; b < kBlocks; ++b) {
    Eigen::MatrixXd rows(static_cast<Eigen::Index>(many), 2);
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      const double x = normal(random);
      rows.row(i) << x + std::sqrt(noise) * normal(random), 2.0 * x;
    }
    Block block{0, many, Eigen::MatrixXd(rows.transpose() * rows)};
    block.product(0, 0) -= many * noise;
    gram.blocks.push_back(block);
    gram.noise(0, 0) += many * noise;
    gram.samples += many;
  }
  Dictionary dictionary = dictionary_of();
  const Fit fit = Fitter(gram, dictionary, folds_of(), {}).fit({0});
  ASSERT_TRUE(fit.is_valid);
  EXPECT_NEAR(fit.values[0], 2.0, 5.0 * 0.0092);
}

TEST(Fitter, RefusesColumnsThatAreTheSameAndValuesBeyondTheirLimits) {
  Eigen::MatrixXd rows = random_rows(3);
  rows.col(1) = 3.0 * rows.col(0);
  const Gram gram = gram_of(rows);
  Dictionary dictionary = dictionary_of();
  dictionary.variants[0].coefficients[0].highest = 1.5;  // The truth is 2.
  const Fitter fitter(gram, dictionary, folds_of(), {});
  EXPECT_FALSE(fitter.fit({1, 0}).is_valid);
  EXPECT_FALSE(fitter.is_determined({1, 0}));
  EXPECT_FALSE(fitter.fit({0}).is_valid);
  EXPECT_TRUE(fitter.fit_unlimited({0}).is_valid);
}

}  // namespace
}  // namespace torquewright::identification
