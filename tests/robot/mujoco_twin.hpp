// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "robot/model/robot.hpp"
#include "tests/dynamics/mujoco_engine.hpp"

namespace torquewright::test {

/// How far our reading of a tree is from MuJoCo's.
struct TwinDifference {
  double mass = 0;      ///< Of all of it, relative.
  double place_m = 0;   ///< Of the centre of mass at random postures.
  double inertia = 0;   ///< About it, of all bodies as one, relative.
  double matrix = 0;    ///< Entries of mass matrices over the roots of their diagonals.
  double bias = 0;      ///< Relative to the largest of its kind.
  double range = 0;     ///< Of joints.
  double passive = 0;   ///< Dampers', springs' and dry friction's forces, relative as the bias.
  std::string trouble;  ///< Where there is nothing to compare.
};

/// Of the tree below the top body of that name; a body without a name is the world's first.
TwinDifference compare_with_mujoco(const hopper::Robot& robot, MujocoEngine& mujoco,
                                   const std::string& top);

}  // namespace torquewright::test
