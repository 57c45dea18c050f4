// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "dynamics/tree.hpp"

namespace torquewright::identification {

/// A robot as what its drives move: bodies and joints, held by its base. Rotors and what joints do
/// of themselves (friction, dampers, springs) are not in it: they are the drives', and identified.
struct RobotLoad {
  std::string file;
  dynamics::Tree tree;                     ///< Its base is fixed, upright.
  std::vector<std::size_t> bodies;         ///< Body that each of the rig's joints carries.
  std::map<std::size_t, double> held_rad;  ///< Position of joints that the log does not hold.
  /// What each of the rig's joints says of its drive, of which an actuator is made where none is
  /// named.
  std::vector<dynamics::Joint> joints;
};

}  // namespace torquewright::identification
