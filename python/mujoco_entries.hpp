// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "hopper/engines/engine.hpp"

namespace torquewright::python {

/// What _mujoco.so holds: the function of hopper/engines that MuJoCo stands behind.
struct MujocoEntries {
  std::unique_ptr<hopper::Engine> (*make)(const hopper::Robot&, const hopper::EngineOptions&);
};

}  // namespace torquewright::python
