// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "hopper/files/draft.hpp"

namespace torquewright::hopper {

/// Reads links and joints of a URDF file; fixed joints become welds. A root link called "world" is
/// a fixed base, any other one floats. Rotor inertia comes from transmissions as Drake writes them
/// (rotor_inertia, gear_ratio). Shapes, meshes, damping and friction are left behind, and said.
/// Throws io::SpecError with all faults.
Imported read_urdf(const std::filesystem::path& file);

}  // namespace torquewright::hopper
