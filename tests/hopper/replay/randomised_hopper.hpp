// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/trials/randomisation_spec.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::hopper::test {

inline const Robot& hopper() {
  static const Robot robot = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json").robot;
  return robot;
}

inline const Randomisation& seeds_tables() {
  static const Randomisation read =
      read_randomisation(TORQUEWRIGHT_SOURCE_DIR "/specs/randomisation/hopper.json").randomisation;
  return read;
}

}  // namespace torquewright::hopper::test
