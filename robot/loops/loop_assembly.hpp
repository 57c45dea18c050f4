// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "robot/mechanisms/loop_geometry.hpp"

namespace torquewright::hopper {

/// A posture of a loop's joints, and how far apart it leaves points that stay together.
struct LoopAssembly {
  Eigen::VectorXd position;  ///< (n x 1)
  double gap_m = 0.0;
};

/// All joints moved by damped steps (Levenberg and Marquardt's), each within its range, until the
/// loop is closed or no step brings its points together further.
LoopAssembly assembled_from(const LoopGeometry& loop, Eigen::VectorXd start);

/// Moves the loop's start to where it is assembled, as objection() wants it: from its own start
/// first, then from others spread over the ranges of its joints. Empty where that came about; else
/// why not, with the least gap that was found.
std::string assemble(LoopGeometry& loop,
                     const std::function<std::string(const LoopGeometry&)>& objection);

}  // namespace torquewright::hopper
