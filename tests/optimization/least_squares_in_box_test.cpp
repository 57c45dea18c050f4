// SPDX-License-Identifier: Apache-2.0
// Oracle: enumeration. The least of a sum of squares in a box is the least of its faces: every
// coordinate free, at its lower or at its upper bound.
#include "optimization/fit/least_squares_in_box.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <cstddef>
#include <random>
#include <vector>

namespace torquewright::optimization {
namespace {

using Place = std::ptrdiff_t;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Boxed {
  MatrixXd columns;
  VectorXd residual, lowest, highest;

  double squares(const VectorXd& x) const { return (residual + columns * x).squaredNorm(); }
  VectorXd solved() const {
    return least_squares_in_box(columns.transpose() * columns, columns.transpose() * residual,
                                lowest, highest);
  }
};

Boxed drawn(Place coordinates, bool has_twins, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> width(0.0, 2.0);
  const Place rows = 12;
  const auto draw = [&](Place n, Place m) {
    return MatrixXd::NullaryExpr(n, m, [&] { return normal(random); });
  };
  Boxed problem{draw(rows, coordinates), draw(rows, 1), VectorXd(coordinates),
                VectorXd(coordinates)};
  if (has_twins) problem.columns.col(1) = 2.0 * problem.columns.col(0);
  for (Place i = 0; i < coordinates; ++i) {
    problem.lowest[i] = -width(random);
    problem.highest[i] = i % 3 == 2 ? 0.0 : width(random);
  }
  return problem;
}

double least_of_all_faces(const Boxed& problem) {
  const Place p = problem.lowest.size();
  double least = problem.residual.squaredNorm();
  std::vector<int> face(static_cast<std::size_t>(p), 0);  // 0: free, 1 and 2: at a bound
  for (;;) {
    VectorXd x = VectorXd::Zero(p);
    std::vector<Place> free;
    for (Place i = 0; i < p; ++i) {
      const int where = face[static_cast<std::size_t>(i)];
      if (where == 0) free.push_back(i);
      if (where == 1) x[i] = problem.lowest[i];
      if (where == 2) x[i] = problem.highest[i];
    }
    if (!free.empty()) {
      const MatrixXd of_free = problem.columns(Eigen::all, free);
      const VectorXd right = -(problem.residual + problem.columns * x);
      const VectorXd least_there = of_free.completeOrthogonalDecomposition().solve(right);
      for (std::size_t k = 0; k < free.size(); ++k) x[free[k]] = least_there[static_cast<Place>(k)];
    }
    const bool is_inside = ((x - problem.lowest).array() > -1e-12).all() &&
                           ((problem.highest - x).array() > -1e-12).all();
    if (is_inside) least = std::min(least, problem.squares(x));
    std::size_t digit = 0;
    while (digit < face.size() && ++face[digit] == 3) face[digit++] = 0;
    if (digit == face.size()) return least;
  }
}

TEST(LeastSquaresInBox, IsTheLeastOfAllFaces) {
  std::mt19937_64 random(11);
  for (int draw = 0; draw < 300; ++draw) {
    const Boxed problem = drawn(1 + draw % 6, false, random);
    const VectorXd x = problem.solved();
    EXPECT_TRUE(((x - problem.lowest).array() >= 0.0).all()) << draw;
    EXPECT_TRUE(((problem.highest - x).array() >= 0.0).all()) << draw;
    EXPECT_NEAR(problem.squares(x), least_of_all_faces(problem), 1e-7) << draw;
  }
}

// Columns that coincide have many such x, and one sum.
TEST(LeastSquaresInBox, TakesColumnsThatCoincide) {
  std::mt19937_64 random(12);
  for (int draw = 0; draw < 100; ++draw) {
    const Boxed problem = drawn(2 + draw % 4, true, random);
    EXPECT_NEAR(problem.squares(problem.solved()), least_of_all_faces(problem), 1e-6) << draw;
  }
}

TEST(LeastSquaresInBox, LeavesWhatNothingMovesAtZero) {
  const MatrixXd power = VectorXd::Unit(2, 0).asDiagonal();
  const VectorXd x = least_squares_in_box(power, VectorXd::Constant(2, -3.0),
                                          VectorXd::Constant(2, -1.0), VectorXd::Constant(2, 1.0));
  EXPECT_EQ(x, VectorXd::Unit(2, 0));
}

}  // namespace
}  // namespace torquewright::optimization
