// SPDX-License-Identifier: Apache-2.0
// Oracles: closed forms of one point, the conditions that any minimum over a cone meets (the
// gradient lies in the dual cone and is square to the force), and random points of the cones.
#include "hopper/contact/cone_least_squares.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Distance of a vector to the cone |t| <= mu n, by the closed form of its projection.
double distance_to_cone(const Vector3d& v, double mu) {
  const double t = v.head<2>().norm();
  if (t <= mu * v.z()) return 0.0;
  if (mu * t <= -v.z()) return v.norm();
  return (t - mu * v.z()) / std::sqrt(1 + mu * mu);
}

struct Problem {
  MatrixXd A;
  VectorXd b;
  VectorXd friction;
};

Problem random_problem(std::mt19937& random, Index points, Index rows) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> rough(0.1, 1.0);
  Problem problem{MatrixXd(rows, 3 * points), VectorXd(rows), VectorXd(points)};
  for (double& value : problem.A.reshaped()) value = normal(random);
  for (double& value : problem.b) value = normal(random);
  for (double& value : problem.friction) value = rough(random);
  return problem;
}

VectorXd gradient(const Problem& problem, const VectorXd& x) {
  return problem.A.transpose() * (problem.A * x - problem.b) + ConeLeastSquares::kTieBreaker * x;
}

// Oracle: two points share 1 upwards as the guide does, which they are free to; with 1.2 asked for,
// each takes of the rest in proportion to 1 / weight.
TEST(ConeLeastSquares, IsNearToAGuide) {
  ConeLeastSquares solver(2);
  MatrixXd A(3, 6);
  A << MatrixXd::Identity(3, 3), MatrixXd::Identity(3, 3);
  ConeLeastSquares::Guide guide{VectorXd::Zero(6), VectorXd::Constant(6, 1e-6)};
  guide.x[2] = 0.7;
  guide.x[5] = 0.3;
  constexpr double kOfWeights = 1e-5;
  const auto asked = [&](double up) {
    EXPECT_EQ(solver.solve(A, Vector3d(0, 0, up), Eigen::Vector2d(0.5, 0.5), &guide),
              ConeLeastSquares::Status::kSolved);
    return Eigen::Vector2d(solver.x()[2], solver.x()[5]);
  };
  EXPECT_LE((asked(1.0) - Eigen::Vector2d(0.7, 0.3)).norm(), kOfWeights);
  guide.weights.tail<3>() /= 3.0;
  EXPECT_LE((asked(1.2) - Eigen::Vector2d(0.75, 0.45)).norm(), kOfWeights);
}

TEST(ConeLeastSquares, MeetsTheConditionsOfAMinimum) {
  std::mt19937 random(7);
  ConeLeastSquares solver(6);
  int at_an_edge = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const Problem problem = random_problem(random, 1 + trial % 6, 2 + trial % 7);
    ASSERT_EQ(solver.solve(problem.A, problem.b, problem.friction),
              ConeLeastSquares::Status::kSolved);
    const VectorXd x = solver.x();
    const VectorXd g = gradient(problem, x);
    double slack = 0.0;
    for (Index i = 0; i < problem.friction.size(); ++i) {
      const double mu = problem.friction[i];
      const Vector3d force = x.segment<3>(3 * i);
      const Vector3d pull = g.segment<3>(3 * i);
      ASSERT_LE(distance_to_cone(force, mu), 1e-12);
      // The dual of the cone with mu is the one with 1/mu.
      EXPECT_LE(distance_to_cone(pull, 1.0 / mu), 1e-6);
      slack += std::abs(force.dot(pull));
      at_an_edge += force.head<2>().norm() > 0.999 * mu * force.z() ? 1 : 0;
    }
    EXPECT_LE(slack, 2 * ConeLeastSquares::kGap / 0.1);  // mu >= 0.1 scales the tangents
  }
  EXPECT_GT(at_an_edge, 300);  // else the cones were never tried
}

// Oracle: a force below a smooth plane can be met in its normal part only; within the cone, all.
TEST(ConeLeastSquares, OfOnePointIsTheProjectionOnItsCone) {
  ConeLeastSquares solver(1);
  const MatrixXd A = MatrixXd::Identity(3, 3);
  std::mt19937 random(8);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 200; ++trial) {
    const Vector3d b(normal(random), normal(random), normal(random));
    const VectorXd friction = VectorXd::Constant(1, 0.5);
    ASSERT_EQ(solver.solve(A, b, friction), ConeLeastSquares::Status::kSolved);
    EXPECT_NEAR((solver.x() - b).norm(), distance_to_cone(b, 0.5), 1e-6);
  }
}

// Oracle: by symmetry four corners of a square under a central load share it equally.
TEST(ConeLeastSquares, SharesOutEvenlyWhatManyCouldCarry) {
  MatrixXd A(6, 12);
  const std::array<Vector3d, 4> corners{Vector3d(1, 1, 0), Vector3d(1, -1, 0), Vector3d(-1, 1, 0),
                                        Vector3d(-1, -1, 0)};
  for (Index i = 0; i < 4; ++i) {
    const Vector3d& r = corners[static_cast<std::size_t>(i)];
    A.block<3, 3>(0, 3 * i).setIdentity();
    A.block<3, 3>(3, 3 * i) << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  }
  VectorXd b = VectorXd::Zero(6);
  b[2] = 1.0;
  ConeLeastSquares solver(4);
  ASSERT_EQ(solver.solve(A, b, VectorXd::Constant(4, 0.6)), ConeLeastSquares::Status::kSolved);
  for (Index i = 0; i < 4; ++i) {
    EXPECT_NEAR((solver.x().segment<3>(3 * i) - Vector3d(0, 0, 0.25)).norm(), 0.0, 1e-7);
  }
  // A load at a corner leaves the others nothing to do but what a plane of forces must.
  b << 0, 0, 1, 1, -1, 0;
  ASSERT_EQ(solver.solve(A, b, VectorXd::Constant(4, 0.6)), ConeLeastSquares::Status::kSolved);
  EXPECT_NEAR(solver.x()[2], 1.0, 1e-4);
  EXPECT_LE((A * solver.x() - b).norm(), 1e-6);
}

}  // namespace
}  // namespace torquewright::hopper
