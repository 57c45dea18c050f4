// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/engines/engine_kind.hpp"

// One line for each engine; its file defines the constant of that name.
#define TORQUEWRIGHT_EVERY_ENGINE(engine) engine(own) engine(mujoco)

namespace torquewright::hopper::engines {

#define TORQUEWRIGHT_DECLARE(name) extern const EngineKind name;
TORQUEWRIGHT_EVERY_ENGINE(TORQUEWRIGHT_DECLARE)
#undef TORQUEWRIGHT_DECLARE

}  // namespace torquewright::hopper::engines
