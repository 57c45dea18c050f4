// SPDX-License-Identifier: Apache-2.0
#include "hopper/contact/cone_least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kFirstBarrier = 1e-1;
constexpr double kBarrierShrinks = 0.1;
constexpr double kCentred = 1e-3;  // Newton decrement over the barrier's weight
constexpr int kMostStepsAtOneBarrier = 50;
constexpr double kArmijo = 1e-4;
constexpr double kBacktrack = 0.5;
constexpr int kMostBacktracks = 60;

double roughness(double friction) { return std::max(friction, ConeLeastSquares::kLeastFriction); }

/// mu^2 n^2 - |t|^2: positive inside the cone, where n > 0 too.
double room(const Vector3d& force, double mu) {
  return mu * mu * force.z() * force.z() - force.head<2>().squaredNorm();
}

bool is_inside(const Vector3d& force, double mu) { return force.z() > 0 && room(force, mu) > 0; }

/// Gradient of room().
Vector3d room_slope(const Vector3d& force, double mu) {
  return {-2 * force.x(), -2 * force.y(), 2 * mu * mu * force.z()};
}

}  // namespace

ConeLeastSquares::ConeLeastSquares(Index most_points) {
  const Index size = 3 * most_points;
  normal_.resize(size, size);
  hessian_.resize(size, size);
  pull_.resize(size);
  gradient_.resize(size);
  x_.resize(size);
  direction_.resize(size);
  trial_.resize(size);
}

ConeLeastSquares::Status ConeLeastSquares::solve(const Eigen::Ref<const Eigen::MatrixXd>& A,
                                                 const Eigen::Ref<const VectorXd>& b,
                                                 const Eigen::Ref<const VectorXd>& friction) {
  size_ = A.cols();
  auto normal = normal_.topLeftCorner(size_, size_);
  normal.noalias() = A.transpose() * A;
  normal.diagonal().array() += kTieBreaker;
  pull_.head(size_).noalias() = A.transpose() * b;
  if (solve_without_cones(b, friction)) return Status::kSolved;
  start(friction);
  // Each cone's barrier has parameter 2: the value lies within 2 n barrier of the least one.
  const auto cones = static_cast<double>(friction.size());
  for (double barrier = kFirstBarrier; 2 * cones * barrier > kGap; barrier *= kBarrierShrinks) {
    int steps = 0;
    while (steps < kMostStepsAtOneBarrier && step(barrier, friction)) ++steps;
    if (steps == kMostStepsAtOneBarrier) return Status::kStalled;
  }
  return Status::kSolved;
}

/// Most postures need no cone: then the shortest of all forces is it.
bool ConeLeastSquares::solve_without_cones(const Eigen::Ref<const VectorXd>&,
                                           const Eigen::Ref<const VectorXd>& friction) {
  factor_.compute(normal_.topLeftCorner(size_, size_));
  x_.head(size_) = factor_.solve(pull_.head(size_));
  if (!x_.head(size_).allFinite()) return false;
  for (Index i = 0; i < friction.size(); ++i) {
    if (!is_inside(x_.segment<3>(3 * i), roughness(friction[i]))) return false;
  }
  return true;
}

void ConeLeastSquares::start(const Eigen::Ref<const VectorXd>& friction) {
  for (Index i = 0; i < friction.size(); ++i) {
    x_.segment<3>(3 * i) = Vector3d(0, 0, 1.0 / static_cast<double>(friction.size()));
  }
}

double ConeLeastSquares::value(const VectorXd& x, double barrier,
                               const Eigen::Ref<const VectorXd>& friction) const {
  const auto inside = x.head(size_);
  double sum = 0.5 * inside.dot(normal_.topLeftCorner(size_, size_) * inside) -
               inside.dot(pull_.head(size_));
  for (Index i = 0; i < friction.size(); ++i) {
    const Vector3d force = x.segment<3>(3 * i);
    const double mu = roughness(friction[i]);
    if (!is_inside(force, mu)) return std::numeric_limits<double>::infinity();
    sum -= barrier * std::log(room(force, mu));
  }
  return sum;
}

/// One damped Newton step; false where the point is centred, or rounding lets it no nearer.
bool ConeLeastSquares::step(double barrier, const Eigen::Ref<const VectorXd>& friction) {
  auto hessian = hessian_.topLeftCorner(size_, size_);
  auto gradient = gradient_.head(size_);
  hessian = normal_.topLeftCorner(size_, size_);
  gradient.noalias() = hessian * x_.head(size_);
  gradient -= pull_.head(size_);
  for (Index i = 0; i < friction.size(); ++i) {
    const Vector3d force = x_.segment<3>(3 * i);
    const double mu = roughness(friction[i]);
    const double inside = room(force, mu);
    const Vector3d slope = room_slope(force, mu);
    gradient.segment<3>(3 * i) -= barrier / inside * slope;
    Matrix3d curvature = slope * slope.transpose() * (barrier / (inside * inside));
    curvature.diagonal() -= barrier / inside * Vector3d(-2, -2, 2 * mu * mu);
    hessian.block<3, 3>(3 * i, 3 * i) += curvature;
  }
  factor_.compute(hessian);
  direction_.head(size_) = -factor_.solve(gradient);
  const double decrement = -direction_.head(size_).dot(gradient);
  if (!(decrement > kCentred * barrier)) return false;
  const double before = value(x_, barrier, friction);
  double share = 1.0;
  for (int i = 0; i < kMostBacktracks; ++i, share *= kBacktrack) {
    trial_.head(size_) = x_.head(size_) + share * direction_.head(size_);
    if (value(trial_, barrier, friction) <= before - kArmijo * share * decrement) {
      x_.head(size_) = trial_.head(size_);
      return true;
    }
  }
  return false;
}

}  // namespace torquewright::hopper
