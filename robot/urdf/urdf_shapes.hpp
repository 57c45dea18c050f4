// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "robot/draft/draft.hpp"
#include "robot/xml/xml.hpp"

namespace torquewright::hopper {

/// Spheres, boxes, cylinders and capsules of a link's <collision>; meshes are not opened.
std::vector<DraftShape> urdf_shapes(const Element& link, const std::string& name, Faults& faults);

}  // namespace torquewright::hopper
