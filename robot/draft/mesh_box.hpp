// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <variant>

namespace torquewright::hopper {

/// The smallest box along a mesh's own axes that holds all its points, in the file's own units.
struct MeshBox {
  Eigen::Vector3d least = Eigen::Vector3d::Zero();
  Eigen::Vector3d most = Eigen::Vector3d::Zero();
};

/// Of an STL file, binary or as text, or of an OBJ file. A few words where there is none: the file
/// is not there, is of another kind, or holds no points that are finite.
std::variant<MeshBox, std::string> mesh_box(const std::filesystem::path& file);

}  // namespace torquewright::hopper
