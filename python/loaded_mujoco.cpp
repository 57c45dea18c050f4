// SPDX-License-Identifier: Apache-2.0
// In the place of hopper's mujoco_engine.cpp, which the linker then leaves where it is: MuJoCo is
// loaded when a replay first asks for it.
#include <fmt/format.h>

#include "python/mujoco_entries.hpp"
#include "python/solver_library.hpp"

namespace torquewright {
namespace {

python::SolverLibrary loaded() { return python::load_solver("_mujoco.so", "torquewright_mujoco"); }

}  // namespace

std::unique_ptr<hopper::Engine> hopper::mujoco_engine(const Robot& robot,
                                                      const EngineOptions& options) {
  const python::SolverLibrary library = loaded();
  if (library.entries == nullptr) return nullptr;
  return static_cast<const python::MujocoEntries*>(library.entries)->make(robot, options);
}

std::optional<std::string> hopper::mujoco_absence() {
  const python::SolverLibrary library = loaded();
  if (library.entries != nullptr) return std::nullopt;
  return fmt::format("MuJoCo cannot be loaded ({}): install libmujoco2.2.2 (Debian)",
                     library.absence);
}

}  // namespace torquewright
