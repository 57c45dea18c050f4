// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "robot/draft/draft.hpp"
#include "robot/mjcf/mjcf_context.hpp"
#include "robot/mjcf/mjcf_meshes.hpp"

namespace torquewright::hopper {

/// A kind of shape, and how many sizes it has.
struct MjcfShape {
  Primitive primitive = Primitive::kSphere;
  std::size_t sizes = 1;
};

/// Returns the shape of a geom's type; nothing where it is none whose volume has a formula.
std::optional<MjcfShape> shape_of(const std::string& type);

/// A geom's sizes, and where it stands, in `pose`, which comes as what it is placed by. A fault
/// where they are missing or not positive.
std::optional<PrimitiveSize> size_of(const Element& geom, const MjcfShape& shape, Placed& pose,
                                     const MjcfContext& context);

/// What a geom may touch the ground with, in the frame of its body; nothing where it collides with
/// nothing or is a plane, a field of heights or a mesh that is none of these.
std::optional<DraftShape> colliding_shape(const Placed& placed, const std::string& body,
                                          const MjcfMeshes& meshes, const MjcfContext& context);

}  // namespace torquewright::hopper
