// SPDX-License-Identifier: Apache-2.0
// Oracle: the inverse of a matrix of two by two, by hand.
#include "identification/experiment/separability.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace torquewright::identification {
namespace {

TEST(Separability, IsThatOfTwoCorrelatedParameters) {
  // Information s (a^2, a b r; a b r, b^2): inverse's diagonal 1/(a^2 (1 - r^2)), ...
  const double a = 3.0, b = 0.02, r = 0.8;
  const Eigen::Matrix2d information{{a * a, a * b * r}, {a * b * r, b * b}};
  const Separability result = separability(information);
  EXPECT_NEAR(result.share[0], 1.0 - r * r, 1e-12);
  EXPECT_NEAR(result.share[1], 1.0 - r * r, 1e-12);
  EXPECT_NEAR(result.standard_error[0], 1.0 / (a * std::sqrt(1.0 - r * r)), 1e-12);
  EXPECT_NEAR(result.standard_error[1], 1.0 / (b * std::sqrt(1.0 - r * r)), 1e-9);
  EXPECT_NEAR(result.smallest_eigenvalue, 1.0 - r, 1e-12);
  EXPECT_EQ(result.nearest[0], 1u);
}

TEST(Separability, OfTheSameColumnTwiceIsNone) {
  const Eigen::Matrix2d information{{4.0, 2.0}, {2.0, 1.0}};
  const Separability result = separability(information);
  EXPECT_LT(result.share[0], 1e-9);
  EXPECT_LT(result.smallest_eigenvalue, 1e-12);
}

TEST(Separability, OfWhatIsNotExcitedIsNone) {
  const Eigen::Matrix2d information{{4.0, 0.0}, {0.0, 0.0}};
  const Separability result = separability(information);
  EXPECT_NEAR(result.standard_error[0], 0.5, 1e-12);
  EXPECT_TRUE(std::isinf(result.standard_error[1]));
  EXPECT_EQ(result.share[1], 0.0);
}

}  // namespace
}  // namespace torquewright::identification
