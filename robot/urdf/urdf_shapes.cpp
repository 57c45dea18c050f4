// SPDX-License-Identifier: Apache-2.0
// Fields: as in urdf_reader.cpp; <capsule> is read by Drake, Bullet and Isaac.
#include "robot/urdf/urdf_shapes.hpp"

#include <optional>

#include "robot/model/rotations.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Vector3d;

/// Radius and half length; of a capsule the length is that of its straight part.
PrimitiveSize round_size(const Element& shape, Faults& faults) {
  return {faults.number(shape, "radius", 0), 0.5 * faults.number(shape, "length", 0), 0};
}

/// Kind and size; nothing of a mesh.
std::optional<DraftShape> shape_in(const Element& geometry, Faults& faults) {
  DraftShape shape;
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
    shape->name = shape->link = name;
    if (const Element* origin = faults.only_child(*collision, "origin")) {
      shape->p_m = faults.vector(*origin, "xyz", Vector3d::Zero());
      shape->R = rotation_of_rpy(faults.vector(*origin, "rpy", Vector3d::Zero()));
    }
    shapes.push_back(std::move(*shape));
  }
  return shapes;
}

}  // namespace torquewright::hopper
