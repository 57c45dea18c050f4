// SPDX-License-Identifier: Apache-2.0
// Fields: MuJoCo's XML reference, "geom".
#include "robot/mjcf/mjcf_shapes.hpp"

#include <algorithm>
#include <vector>

namespace torquewright::hopper {
namespace {

using Eigen::Vector3d;

constexpr double kMjcfFriction = 1.0;  // where a geom states none

/// From one end to the other along z: where the middle is, and half the length.
double lay_between(const std::vector<double>& ends, Placed& pose) {
  const Vector3d from(ends[0], ends[1], ends[2]);
  const Vector3d to(ends[3], ends[4], ends[5]);
  const double length_m = (to - from).norm();
  pose.p_m += pose.R * (0.5 * (from + to));
  if (length_m > 0) pose.R = pose.R * rotation_of_z(to - from);
  return 0.5 * length_m;
}

}  // namespace

std::optional<MjcfShape> shape_of(const std::string& type) {
  if (type.empty() || type == "sphere") return MjcfShape{Primitive::kSphere, 1};
  if (type == "capsule") return MjcfShape{Primitive::kCapsule, 2};
  if (type == "cylinder") return MjcfShape{Primitive::kCylinder, 2};
  if (type == "box") return MjcfShape{Primitive::kBox, 3};
  if (type == "ellipsoid") return MjcfShape{Primitive::kEllipsoid, 3};
  return std::nullopt;
}

std::optional<PrimitiveSize> size_of(const Element& geom, const MjcfShape& shape, Placed& pose,
                                     const MjcfContext& context) {
  Faults& faults = context.faults;
  const auto ends = faults.numbers(geom, "fromto", 6);
  PrimitiveSize size_m = PrimitiveSize::Zero();
  if (const auto stated = faults.numbers(geom, "size", 1, 3)) {
    std::copy(stated->begin(), stated->end(), size_m.data());
  }
  if (ends && shape.primitive != Primitive::kSphere) {
    // Across its length a shape is as wide as it is high.
    size_m[1] = size_m[0];
    size_m[static_cast<Eigen::Index>(shape.sizes) - 1] = lay_between(*ends, pose);
  } else {
    pose = pose_of(pose, geom, context);
  }
  if ((size_m.head(static_cast<Eigen::Index>(shape.sizes)).array() > 0).all()) return size_m;
  faults.report(geom, "its sizes are missing, or not positive");
  return std::nullopt;
}

std::optional<DraftShape> colliding_shape(const Placed& placed, const std::string& body,
                                          const MjcfMeshes& meshes, const MjcfContext& context) {
  const Element geom = context.defaults.completed(*placed.element, placed.childclass);
  Faults& faults = context.faults;
  const auto kind = shape_of(attribute(geom, "type"));
  const auto mesh =
      attribute(geom, "type") == "mesh" ? meshes.find(attribute(geom, "mesh")) : meshes.end();
  const bool has_sizes =
      kind && find_attribute(geom, "mesh") == nullptr && find_attribute(geom, "size") != nullptr;
  if (!has_sizes && mesh == meshes.end()) return std::nullopt;
  if (faults.number(geom, "contype", 1) == 0 && faults.number(geom, "conaffinity", 1) == 0) {
    return std::nullopt;
  }
  DraftShape shape;
  const char* ending = "_mesh";
  Placed pose = placed;
  if (has_sizes) {
    const auto size_m = size_of(geom, *kind, pose, context);
    if (!size_m) return std::nullopt;
    shape.primitive = kind->primitive;
    shape.size_m = *size_m;
    ending = kind->primitive == Primitive::kSphere ? "_ball" : "_shape";
  } else {
    pose = pose_of(pose, geom, context);
    shape.mesh = mesh->second;
  }
  shape.name = attribute(geom, "name");
  shape.link = body;
  shape.group = attribute(*placed.element, "class");
  if (is_blank(shape.name)) shape.name = (is_blank(body) ? "body" : body) + ending;
  shape.p_m = pose.p_m;
  shape.R = pose.R;
  const auto friction = faults.numbers(geom, "friction", 1, 3);
  shape.friction_coefficient = friction ? friction->front() : kMjcfFriction;
  return shape;
}

}  // namespace torquewright::hopper
