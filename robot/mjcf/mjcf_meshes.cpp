// SPDX-License-Identifier: Apache-2.0
// Fields: MuJoCo's XML reference, "asset/mesh" and "compiler".
#include "robot/mjcf/mjcf_meshes.hpp"

#include <sstream>

namespace torquewright::hopper {
namespace {

using Eigen::Vector3d;
namespace fs = std::filesystem;

fs::path folder_of(const Element& mujoco, const fs::path& main) {
  std::string of_meshes, of_assets;
  for (const Element* compiler : children(mujoco, "compiler")) {
    for (const auto& [key, value] : compiler->attributes) {
      if (key == "meshdir") of_meshes = value;
      if (key == "assetdir") of_assets = value;
    }
  }
  return main.parent_path() / (of_meshes.empty() ? of_assets : of_meshes);
}

/// Points that the file itself states, three numbers each; none where it is no such list.
std::optional<MeshBox> stated_box(const std::string& vertices) {
  std::istringstream numbers(vertices);
  std::optional<MeshBox> box;
  for (Vector3d point; numbers >> point[0] >> point[1] >> point[2];) {
    if (!point.allFinite()) return std::nullopt;
    if (!box) box = MeshBox{point, point};
    box->least = box->least.cwiseMin(point);
    box->most = box->most.cwiseMax(point);
  }
  return box;
}

}  // namespace

MjcfMeshes mesh_assets(const Element& mujoco, const fs::path& main, const MjcfContext& context) {
  const fs::path folder = folder_of(mujoco, main);
  MjcfMeshes meshes;
  for (const Element* asset : children(mujoco, "asset")) {
    for (const Element* stated : children(*asset, "mesh")) {
      const Element mesh = context.defaults.completed(*stated, "");
      const bool is_moved =
          find_attribute(mesh, "refpos") != nullptr || find_attribute(mesh, "refquat") != nullptr;
      const std::string file = attribute(mesh, "file"), name = attribute(mesh, "name");
      if (is_moved) continue;
      DraftMesh read;
      read.file = folder / file;
      read.scale = context.faults.vector(mesh, "scale", Vector3d::Ones());
      read.stated = stated_box(attribute(mesh, "vertex"));
      meshes[name.empty() ? fs::path(file).stem().string() : name] = read;
    }
  }
  return meshes;
}

}  // namespace torquewright::hopper
