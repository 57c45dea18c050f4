// SPDX-License-Identifier: Apache-2.0
// MuJoCo's models from texts and files, and back into a robot.
#pragma once

#include <mujoco/mujoco.h>

#include <filesystem>
#include <memory>
#include <string>

#include "tests/oracles/robot_bench/robot.hpp"

namespace torquewright::oracles::robot_bench {

struct FreeModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct FreeData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using Model = std::unique_ptr<mjModel, FreeModel>;
using Data = std::unique_ptr<mjData, FreeData>;

/// Throws std::runtime_error with MuJoCo's own words.
Model compile(const std::string& text);

/// An MJCF or URDF as its author wrote it, without what needs meshes or plays no part: shapes,
/// pictures, sensors, motors, and attributes that MuJoCo 2.2.2 does not know.
Model compile_without_shapes(const std::filesystem::path& file);

/// Bodies without a joint become part of what carries them. Only hinges below the base.
Robot robot_of(const mjModel& model, const std::string& name);

}  // namespace torquewright::oracles::robot_bench
