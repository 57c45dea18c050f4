// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "hopper/files/draft.hpp"

namespace torquewright::hopper {

/// Reads the one tree of an MJCF file: bodies with <inertial>, hinges and slides (one per body),
/// armature as reflected inertia, defaults and their classes. A free joint at its top floats;
/// slides along x and z and a hinge about y there are a planar base; anything else stands on a
/// fixed base. Shapes, damping, actuators are left behind, and said; loops closed by equality
/// constraints, ball joints, several joints in one body and bodies whose mass only their shapes say
/// are faults. Throws io::SpecError with all faults.
Imported read_mjcf(const std::filesystem::path& file);

}  // namespace torquewright::hopper
