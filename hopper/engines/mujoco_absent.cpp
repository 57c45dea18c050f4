// SPDX-License-Identifier: Apache-2.0
// In place of mujoco_engine.cpp where MuJoCo was not installed when the program was built.
#include "hopper/engines/engine.hpp"

namespace torquewright::hopper {

std::unique_ptr<Engine> mujoco_engine(const Robot&, const EngineOptions&) { return nullptr; }

std::optional<std::string> mujoco_absence() {
  return "this program was built without MuJoCo: install libmujoco-dev (Debian) and build again";
}

}  // namespace torquewright::hopper
