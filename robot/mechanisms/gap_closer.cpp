// SPDX-License-Identifier: Apache-2.0
// Equations: docs/derivations/mechanisms.md, "Loop".
#include "robot/mechanisms/gap_closer.hpp"

#include <algorithm>
#include <cmath>

#include "robot/mechanisms/loop_gaps.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kMostGap_m = 1e-6;    // what hinges that are not quite parallel may leave
constexpr double kMostDivisions = 32;  // of a step, before a loop is said to end there
constexpr double kMostJump = 0.5;      // rad or m of a link in one step: beyond, it is another way
constexpr int kMostMoves = 25;
constexpr double kMoved = 1e-14;

std::vector<Index> felt_columns(const LoopGeometry& loop, const MatrixXd& jacobian) {
  MatrixXd left = jacobian;
  const double scale = left.rightCols(loop.links()).colwise().norm().maxCoeff();
  std::vector<Index> open;
  for (Index i = loop.joints; i < left.cols(); ++i) open.push_back(i);
  std::vector<Index> felt;
  const auto take = [&](Index column) {
    const VectorXd direction = left.col(column).normalized();
    left -= direction * (direction.transpose() * left);
    left.col(column).setZero();
    felt.push_back(column);
    open.erase(std::find(open.begin(), open.end(), column));
  };
  for (const std::size_t body : loop.turned) {
    const auto column = static_cast<Index>(body) - 1;
    const bool is_open = std::find(open.begin(), open.end(), column) != open.end();
    if (is_open && left.col(column).norm() > kSingularLever * scale) take(column);
  }
  while (!open.empty()) {
    const auto best = *std::max_element(open.begin(), open.end(), [&](Index one, Index other) {
      return left.col(one).norm() < left.col(other).norm();
    });
    if (!(left.col(best).norm() > kSingularLever * scale)) break;
    take(best);
  }
  std::sort(felt.begin(), felt.end());
  return felt;
}

}  // namespace

std::vector<Index> felt_at_start(const LoopGeometry& loop) {
  dynamics::TreeState state(without_names(loop.tree));
  state.set(loop.start, VectorXd::Zero(loop.start.size()));
  return felt_columns(loop, gap_jacobian(state, loop.closures));
}

GapCloser::GapCloser(const LoopGeometry& loop, const std::vector<Index>& felt)
    : loop_(loop), felt_(felt), state_(without_names(loop.tree)) {}

bool GapCloser::close(VectorXd& position) {
  for (int move = 0; move < kMostMoves; ++move) {
    const VectorXd gaps = set(position);
    if (!factor()) return false;
    const VectorXd step = factors_.solve(gaps);
    if (!step.allFinite()) return false;
    position(felt_) -= step;
    if (step.cwiseAbs().maxCoeff() <= kMoved) break;
  }
  return set(position).cwiseAbs().maxCoeff() <= kMostGap_m && factor();
}

bool GapCloser::walk(VectorXd& position, const VectorXd& joints, const std::vector<double>& most) {
  double longest = 0;  // of the way, in steps
  for (Index k = 0; k < joints.size(); ++k) {
    longest = std::max(longest,
                       2 * std::abs(joints[k] - position[k]) / most[static_cast<std::size_t>(k)]);
  }
  const VectorXd from = position.head(joints.size());
  const VectorXd way = joints - from;
  double done = 0, step = 1 / std::max(1.0, std::ceil(longest));
  const double shortest = step / kMostDivisions;
  while (done < 1) {
    const double next = done + step >= 1 - 1e-12 ? 1 : done + step;
    VectorXd there = position;
    there.head(joints.size()) = next == 1 ? joints : VectorXd(from + way * next);
    const bool is_closed = close(there) && (there - position).cwiseAbs().maxCoeff() <= kMostJump;
    if (is_closed) {
      position = there;
      done = next;
      continue;
    }
    step /= 2;
    if (step < shortest) return false;
  }
  // Where nothing was to go, the factors are still to be found.
  return longest > 0 || close(position);
}

MatrixXd GapCloser::inverse() const {
  const Index rows = 3 * static_cast<Index>(loop_.closures.size());
  return factors_.solve(MatrixXd::Identity(rows, rows));
}

VectorXd GapCloser::set(const VectorXd& position) {
  state_.set(position, VectorXd::Zero(position.size()));
  return gaps_m(state_, loop_.closures);
}

bool GapCloser::factor() {
  factors_.compute(gap_jacobian(state_, loop_.closures)(Eigen::all, felt_));
  const auto diagonal = factors_.matrixR().diagonal().cwiseAbs();
  const auto count = static_cast<Index>(felt_.size());
  return diagonal.size() >= count && diagonal[count - 1] > kSingularLever * diagonal[0];
}

}  // namespace torquewright::hopper
