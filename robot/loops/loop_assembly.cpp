// SPDX-License-Identifier: Apache-2.0
#include "robot/loops/loop_assembly.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "robot/mechanisms/loop_gaps.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kStarts = 40;
constexpr int kMostDampedSteps = 200;
constexpr double kClosed_m = 1e-10;
constexpr double kNearlyClosed_m = 1e-6;  // as for hinges that are not quite parallel
constexpr double kFreeReach_m = 0.2;      // of a slide without a range
/// Bases of Halton's sequence, by joint; joints beyond share them.
constexpr std::array kPrimes{2, 3, 5, 7, 11, 13, 17, 19, 23, 29};

const dynamics::Joint& joint_of_row(const LoopGeometry& loop, Index row) {
  return loop.tree.bodies[static_cast<std::size_t>(row) + 1].joint;
}

VectorXd within_ranges(const LoopGeometry& loop, VectorXd position) {
  for (Index i = 0; i < position.size(); ++i) {
    const dynamics::JointLimits& limits = joint_of_row(loop, i).limits;
    position[i] = std::clamp(position[i], limits.position_min, limits.position_max);
  }
  return position;
}

double radical_inverse(int number, int base) {
  double inverse = 0, digit = 1.0 / base;
  for (; number > 0; number /= base, digit /= base) inverse += digit * (number % base);
  return inverse;
}

/// The loop's own start, then points that fill the ranges evenly.
VectorXd start_of(const LoopGeometry& loop, int number) {
  VectorXd start = loop.start;
  for (Index i = 0; number > 0 && i < start.size(); ++i) {
    const dynamics::Joint& joint = joint_of_row(loop, i);
    const double reach =
        joint.kind == dynamics::JointKind::kRevolute ? std::numbers::pi : kFreeReach_m;
    const double least = std::max(joint.limits.position_min, loop.start[i] - reach);
    const double most = std::min(joint.limits.position_max, loop.start[i] + reach);
    const int base = kPrimes[static_cast<std::size_t>(i) % kPrimes.size()];
    start[i] = std::lerp(least, most, radical_inverse(number, base));
  }
  return start;
}

}  // namespace

LoopAssembly assembled_from(const LoopGeometry& loop, VectorXd start) {
  dynamics::TreeState state(without_names(loop.tree));
  const VectorXd rest = VectorXd::Zero(start.size());
  const auto gaps_at = [&](const VectorXd& position) {
    state.set(position, rest);
    return gaps_m(state, loop.closures);
  };
  VectorXd position = within_ranges(loop, std::move(start));
  VectorXd gaps = gaps_at(position);
  double damping = 1e-3;
  for (int step = 0; step < kMostDampedSteps && gaps.cwiseAbs().maxCoeff() > kClosed_m; ++step) {
    state.set(position, rest);
    const MatrixXd G = gap_jacobian(state, loop.closures);
    MatrixXd normal = G.transpose() * G;
    const double scale = std::max(normal.diagonal().maxCoeff(), 1e-12);
    normal.diagonal().array() += damping * scale;
    const VectorXd next = within_ranges(loop, position - normal.ldlt().solve(G.transpose() * gaps));
    const VectorXd there = gaps_at(next);
    if (!(there.squaredNorm() < gaps.squaredNorm())) {
      damping *= 10;
      if (damping > 1e6) break;
      continue;
    }
    position = next;
    gaps = there;
    damping = std::max(damping / 10, 1e-14);
  }
  return {position, gaps.cwiseAbs().maxCoeff()};
}

std::string assemble(LoopGeometry& loop,
                     const std::function<std::string(const LoopGeometry&)>& objection) {
  std::string why;
  double least_m = std::numeric_limits<double>::infinity();
  LoopGeometry moved = loop;
  for (int number = 0; number < kStarts; ++number) {
    LoopAssembly found = assembled_from(loop, start_of(loop, number));
    least_m = std::min(least_m, found.gap_m);
    if (found.gap_m > kNearlyClosed_m) continue;
    moved.start = std::move(found.position);
    why = objection(moved);
    if (!why.empty()) continue;
    loop.start = std::move(moved.start);
    return "";
  }
  if (!why.empty()) return why;
  return fmt::format(
      "does not close from the file's posture, nor from {} others within its joints' ranges: its "
      "points stay {:.3g} m apart",
      kStarts - 1, least_m);
}

}  // namespace torquewright::hopper
