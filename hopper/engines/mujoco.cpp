// SPDX-License-Identifier: Apache-2.0
// Whether it is there or not: mujoco_engine.cpp, mujoco_absent.cpp.
#include "hopper/engines/every_engine.hpp"

namespace torquewright::hopper::engines {

const EngineKind mujoco = {.name = "mujoco",
                           .sentence = "where it was built in",
                           .absence = mujoco_absence,
                           .make = mujoco_engine};

}  // namespace torquewright::hopper::engines
