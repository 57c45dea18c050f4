// SPDX-License-Identifier: Apache-2.0
#include "python/mujoco_entries.hpp"

extern "C" __attribute__((visibility("default"))) const void* torquewright_mujoco() {
  using namespace torquewright;
  static constexpr python::MujocoEntries entries{hopper::mujoco_engine};
  return &entries;
}
