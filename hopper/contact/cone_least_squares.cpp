// SPDX-License-Identifier: Apache-2.0
#include "hopper/contact/cone_least_squares.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::VectorXd;

constexpr int kMostSteps = 60;
constexpr double kAim = 1e-12;        // of gap and balance; rounding may end the search before
constexpr double kShareKept = 0.995;  // of the way to the boundary
constexpr double kShortest = 1e-10;   // a share of a step that leads nowhere
constexpr double kFloor = 1e-14;      // on the diagonal of frictionless tangents

}  // namespace

ConeLeastSquares::ConeLeastSquares(Index most_points) {
  const Index size = 3 * most_points;
  for (VectorXd* vector :
       {&pull_, &scale_, &x_, &best_, &dual_, &residual_, &step_, &dual_step_, &complement_}) {
    vector->setZero(size);
  }
  normal_.setZero(size, size);
  system_.setZero(size, size);
  scaling_.resize(static_cast<std::size_t>(most_points));
  unscaling_.resize(static_cast<std::size_t>(most_points));
}

ConeLeastSquares::Status ConeLeastSquares::solve(const Eigen::Ref<const Eigen::MatrixXd>& A,
                                                 const Eigen::Ref<const VectorXd>& b,
                                                 const Eigen::Ref<const VectorXd>& friction,
                                                 const Guide* guide) {
  size_ = A.cols();
  points_ = friction.size();
  auto normal = normal_.topLeftCorner(size_, size_);
  normal.noalias() = A.transpose() * A;
  pull_.head(size_).noalias() = A.transpose() * b;
  if (guide != nullptr) {
    normal.diagonal() += guide->weights;
    pull_.head(size_) += guide->weights.cwiseProduct(guide->x);
  } else {
    normal.diagonal().array() += kTieBreaker;
  }
  if (solve_without_cones(friction)) return Status::kSolved;
  for (Index i = 0; i < points_; ++i) {
    scale_.segment<3>(3 * i) << friction[i], friction[i], 1.0;
  }
  const auto scale = scale_.head(size_);
  normal = (scale.asDiagonal() * normal * scale.asDiagonal()).eval();
  normal.diagonal().array() += kFloor;
  pull_.head(size_) = pull_.head(size_).cwiseProduct(scale);
  const Status status = solve_inside_cones();
  x_.head(size_) = x_.head(size_).cwiseProduct(scale);
  return status;
}

/// Most postures need no cone: then the shortest of all forces is it.
bool ConeLeastSquares::solve_without_cones(const Eigen::Ref<const VectorXd>& friction) {
  factor_.compute(normal_.topLeftCorner(size_, size_));
  x_.head(size_) = factor_.solve(pull_.head(size_));
  if (!x_.head(size_).allFinite()) return false;
  for (Index i = 0; i < points_; ++i) {
    const Eigen::Vector3d force = x_.segment<3>(3 * i);
    if (!(force.head<2>().norm() <= friction[i] * force.z())) return false;
  }
  return true;
}

void ConeLeastSquares::start() {
  for (Index i = 0; i < points_; ++i) {
    x_.segment<3>(3 * i) << 0, 0, 1.0;
    dual_.segment<3>(3 * i) << 0, 0, 1.0;
  }
}

double ConeLeastSquares::gap() const { return x_.head(size_).dot(dual_.head(size_)); }

double ConeLeastSquares::share_of_step() const {
  double share = 1.0;
  for (Index i = 0; i < points_; ++i) {
    share = std::min(share, share_to_boundary(x_.segment<3>(3 * i), step_.segment<3>(3 * i)));
    share =
        std::min(share, share_to_boundary(dual_.segment<3>(3 * i), dual_step_.segment<3>(3 * i)));
  }
  return share;
}

/// Newton's step to complementarity `centring`; the correction uses the prediction's own product.
void ConeLeastSquares::take_step(double centring, bool is_prediction) {
  for (Index i = 0; i < points_; ++i) {
    const Matrix3d& W = scaling_[static_cast<std::size_t>(i)];
    const Matrix3d& inverse = unscaling_[static_cast<std::size_t>(i)];
    const ConeVector dual = dual_.segment<3>(3 * i);
    const ConeVector middle = W * dual;
    ConeVector asked = -cone_product(middle, middle) + ConeVector(0, 0, centring);
    if (!is_prediction) {
      const ConeVector step = step_.segment<3>(3 * i);
      const ConeVector dual_step = dual_step_.segment<3>(3 * i);
      asked -= cone_product(inverse * step, W * dual_step);
    }
    complement_.segment<3>(3 * i) = inverse * cone_quotient(asked, middle);
  }
  step_.head(size_) = factor_.solve(complement_.head(size_) - residual_.head(size_));
  for (Index i = 0; i < points_; ++i) {
    const Matrix3d& inverse = unscaling_[static_cast<std::size_t>(i)];
    dual_step_.segment<3>(3 * i) =
        complement_.segment<3>(3 * i) - inverse * (inverse * step_.segment<3>(3 * i));
  }
}

ConeLeastSquares::Status ConeLeastSquares::solve_inside_cones() {
  start();
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMostSteps; ++i) {
    const auto normal = normal_.topLeftCorner(size_, size_);
    residual_.head(size_).noalias() = normal * x_.head(size_);
    residual_.head(size_) -= pull_.head(size_) + dual_.head(size_);
    const double error = std::max(gap(), residual_.head(size_).cwiseAbs().maxCoeff());
    if (error < least) {
      least = error;
      best_.head(size_) = x_.head(size_);
    }
    if (error <= kAim) break;
    system_.topLeftCorner(size_, size_) = normal;
    for (Index k = 0; k < points_; ++k) {
      Matrix3d& W = scaling_[static_cast<std::size_t>(k)];
      W = nesterov_todd(x_.segment<3>(3 * k), dual_.segment<3>(3 * k));
      Matrix3d& inverse = unscaling_[static_cast<std::size_t>(k)];
      inverse = W.inverse();
      system_.block<3, 3>(3 * k, 3 * k) += inverse * inverse;
    }
    factor_.compute(system_.topLeftCorner(size_, size_));
    take_step(0.0, true);
    const double predicted = share_of_step();
    // Mehrotra: the worse the prediction fares, the more centring.
    const double mean = gap() / static_cast<double>(points_);
    take_step(std::pow(1.0 - predicted, 3) * mean, false);
    const double share = std::min(1.0, kShareKept * share_of_step());
    if (!(share > kShortest) || !step_.head(size_).allFinite()) break;
    x_.head(size_) += share * step_.head(size_);
    dual_.head(size_) += share * dual_step_.head(size_);
  }
  x_.head(size_) = best_.head(size_);
  return least <= kGap ? Status::kSolved : Status::kStalled;
}

}  // namespace torquewright::hopper
