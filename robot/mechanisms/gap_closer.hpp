// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/QR>
#include <vector>

#include "dynamics/tree_state.hpp"
#include "robot/mechanisms/loop_geometry.hpp"

namespace torquewright::hopper {

constexpr double kSingularLever = 1e-7;  // of the greatest, as of the closed forms

/// Of the links' columns those that the closures hold where the loop starts, the turned ones first:
/// all but the spins of rods between balls.
std::vector<Eigen::Index> felt_at_start(const LoopGeometry& loop);

/// Moves the felt links by Newton's method until the loop is closed. Keeps references to both.
class GapCloser {
 public:
  GapCloser(const LoopGeometry& loop, const std::vector<Eigen::Index>& felt);

  /// False where that does not come about.
  bool close(Eigen::VectorXd& position);
  /// From a closed posture to one where the robot's joints stand elsewhere, by halves of `most` of
  /// each; by shorter steps where links move fast.
  bool walk(Eigen::VectorXd& position, const Eigen::VectorXd& joints,
            const std::vector<double>& most);

  /// Where it was closed last: what moves the felt columns by gaps.
  Eigen::MatrixXd inverse() const;
  const dynamics::TreeState& state() const { return state_; }

 private:
  Eigen::VectorXd set(const Eigen::VectorXd& position);
  bool factor();

  const LoopGeometry& loop_;
  const std::vector<Eigen::Index>& felt_;
  dynamics::TreeState state_;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors_;
};

}  // namespace torquewright::hopper
