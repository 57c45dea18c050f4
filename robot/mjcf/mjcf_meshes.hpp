// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "robot/draft/draft.hpp"
#include "robot/mjcf/mjcf_context.hpp"

namespace torquewright::hopper {

/// By the name that geoms call them.
using MjcfMeshes = std::map<std::string, DraftMesh>;

/// The meshes of a file's assets, none of them opened; those that refpos or refquat move are left
/// out. `main`: the file that includes all others.
MjcfMeshes mesh_assets(const Element& mujoco, const std::filesystem::path& main,
                       const MjcfContext& context);

}  // namespace torquewright::hopper
