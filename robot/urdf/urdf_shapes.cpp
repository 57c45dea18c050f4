// SPDX-License-Identifier: Apache-2.0
// Fields: as in urdf_reader.cpp; <capsule> is read by Drake, Bullet and Isaac.
#include "robot/urdf/urdf_shapes.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>

#include "robot/parts/rotations.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Vector3d;

/// Radius and half length; of a capsule the length is that of its straight part.
PrimitiveSize round_size(const Element& shape, Faults& faults) {
  return {faults.number(shape, "radius", 0), 0.5 * faults.number(shape, "length", 0), 0};
}

/// "package://NAME/PLACE" is looked for as NAME/PLACE and as PLACE, from the file's folder upwards.
std::filesystem::path mesh_file(std::string name, const std::filesystem::path& folder) {
  constexpr std::string_view kPackage = "package://", kFile = "file://";
  if (name.starts_with(kFile)) return name.substr(kFile.size());
  if (!name.starts_with(kPackage)) return folder / name;
  name.erase(0, kPackage.size());
  const std::string place = name.substr(std::min(name.size(), name.find('/') + 1));
  std::error_code unknown;
  // A file that is named alone has no folder, of which nothing absolute can be made.
  const std::filesystem::path begin = std::filesystem::absolute(folder.empty() ? "." : folder);
  for (std::filesystem::path at = begin.lexically_normal();; at = at.parent_path()) {
    for (const std::string& tried : {name, place}) {
      if (std::filesystem::is_regular_file(at / tried, unknown)) return at / tried;
    }
    if (!at.has_relative_path()) return folder / place;
  }
}

/// Kind and size; of a mesh its file.
std::optional<DraftShape> shape_in(const Element& geometry, Faults& faults) {
  DraftShape shape;
  if (const Element* mesh = child(geometry, "mesh")) {
    const std::string name = attribute(*mesh, "filename");
    if (name.empty()) return std::nullopt;
    const auto folder = std::filesystem::path(*mesh->file).parent_path();
    shape.mesh =
        DraftMesh{mesh_file(name, folder), faults.vector(*mesh, "scale", Vector3d::Ones())};
    return shape;
  }
  if (const Element* sphere = child(geometry, "sphere")) {
    shape.size_m[0] = faults.number(*sphere, "radius", 0);
    return shape.size_m[0] > 0 ? std::optional(shape) : std::nullopt;
  }
  if (const Element* box = child(geometry, "box")) {
    shape.primitive = Primitive::kBox;
    shape.size_m = 0.5 * faults.vector(*box, "size", Vector3d::Zero());
    return (shape.size_m.array() > 0).all() ? std::optional(shape) : std::nullopt;
  }
  for (const auto& [word, primitive] :
       {std::pair{"cylinder", Primitive::kCylinder}, {"capsule", Primitive::kCapsule}}) {
    const Element* element = child(geometry, word);
    if (element == nullptr) continue;
    shape.primitive = primitive;
    shape.size_m = round_size(*element, faults);
    return shape.size_m[0] > 0 ? std::optional(shape) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::vector<DraftShape> urdf_shapes(const Element& link, const std::string& name, Faults& faults) {
  std::vector<DraftShape> shapes;
  for (const Element* collision : children(link, "collision")) {
    const Element* geometry = faults.only_child(*collision, "geometry");
    auto shape = geometry == nullptr ? std::nullopt : shape_in(*geometry, faults);
    if (!shape) continue;
    shape->link = name;
    shape->name = attribute(*collision, "name");
    if (is_blank(shape->name)) shape->name = name;
    if (const Element* origin = faults.only_child(*collision, "origin")) {
      shape->p_m = faults.vector(*origin, "xyz", Vector3d::Zero());
      shape->R = rotation_of_rpy(faults.vector(*origin, "rpy", Vector3d::Zero()));
    }
    shapes.push_back(std::move(*shape));
  }
  return shapes;
}

}  // namespace torquewright::hopper
