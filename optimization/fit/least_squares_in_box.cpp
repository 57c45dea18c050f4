// SPDX-License-Identifier: Apache-2.0
#include "optimization/fit/least_squares_in_box.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <cstddef>
#include <vector>

namespace torquewright::optimization {
namespace {

using Place = std::ptrdiff_t;
using Eigen::VectorXd;

constexpr double kRidge = 1e-9;  // relative, of columns that coincide
constexpr double kStationary =
    1e-9;  // of the slope that the coordinate has at 0, or would be let go
constexpr Place kRoundsPerCoordinate = 6;

class BoxedSquares {
 public:
  BoxedSquares(const Eigen::MatrixXd& power, const VectorXd& right, const VectorXd& lowest,
               const VectorXd& highest)
      : power_(power), right_(right), lowest_(lowest), highest_(highest) {
    x_.setZero(right.size());
    for (Place i = 0; i < right.size(); ++i) {
      if (power(i, i) > 0.0) free_.push_back(i);
    }
  }

  VectorXd run() {
    const Place rounds = kRoundsPerCoordinate * (x_.size() + 1);
    for (Place round = 0; round < rounds; ++round) {
      const VectorXd target = least_over_free();
      if (!target.allFinite()) break;
      if (go_towards(target)) continue;
      const Place inwards = most_inwards();
      if (inwards < 0) break;
      free_.push_back(inwards);
    }
    return x_;
  }

 private:
  /// The free coordinates at which the sum is least while the others stay.
  VectorXd least_over_free() const {
    Eigen::MatrixXd power = power_(free_, free_);
    power.diagonal() *= 1.0 + kRidge;
    VectorXd held = x_;
    for (const Place i : free_) held[i] = 0.0;
    const VectorXd right = (right_ + power_ * held)(free_);
    return power.ldlt().solve(-right);
  }

  /// Moves there, or to the first bound on the way, whose coordinate is then held. False: it was
  /// reached.
  bool go_towards(const VectorXd& target) {
    double share = 1.0;
    std::size_t first = free_.size();
    for (std::size_t k = 0; k < free_.size(); ++k) {
      const Place i = free_[k];
      const double to = target[static_cast<Place>(k)];
      const double bound = to > highest_[i] ? highest_[i] : lowest_[i];
      if (to >= lowest_[i] && to <= highest_[i]) continue;
      const double until = (bound - x_[i]) / (to - x_[i]);
      if (until >= share) continue;
      share = until;
      first = k;
    }
    for (std::size_t k = 0; k < free_.size(); ++k) {
      x_[free_[k]] += share * (target[static_cast<Place>(k)] - x_[free_[k]]);
    }
    if (first == free_.size()) return false;
    const Place held = free_[first];
    x_[held] = target[static_cast<Place>(first)] > highest_[held] ? highest_[held] : lowest_[held];
    free_.erase(free_.begin() + static_cast<std::ptrdiff_t>(first));
    return true;
  }

  /// The held coordinate along which the sum falls most inwards, by the columns' sizes; -1: none.
  Place most_inwards() const {
    const VectorXd slope = power_ * x_ + right_;
    Place best = -1;
    double most = 0.0;
    for (Place i = 0; i < x_.size(); ++i) {
      const bool is_low = x_[i] <= lowest_[i], is_high = x_[i] >= highest_[i];
      const bool can_move = power_(i, i) > 0.0 && lowest_[i] < highest_[i];
      if (!can_move || (!is_low && !is_high) || is_free(i)) continue;
      const double inwards = is_low ? -slope[i] : slope[i];
      const double scale = std::abs(right_[i]) + (power_.row(i).cwiseAbs() * x_.cwiseAbs()).value();
      if (inwards <= kStationary * scale || inwards / std::sqrt(power_(i, i)) <= most) continue;
      most = inwards / std::sqrt(power_(i, i));
      best = i;
    }
    return best;
  }

  bool is_free(Place i) const {
    for (const Place each : free_) {
      if (each == i) return true;
    }
    return false;
  }

  const Eigen::MatrixXd& power_;
  const VectorXd& right_;
  const VectorXd& lowest_;
  const VectorXd& highest_;
  VectorXd x_;
  std::vector<Place> free_;
};

}  // namespace

VectorXd least_squares_in_box(const Eigen::MatrixXd& power, const VectorXd& right,
                              const VectorXd& lowest, const VectorXd& highest) {
  return BoxedSquares(power, right, lowest, highest).run();
}

}  // namespace torquewright::optimization
