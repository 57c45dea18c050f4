// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "robot/draft/draft.hpp"
#include "robot/draft/import_options.hpp"

namespace torquewright::hopper {

/// Reads links and joints of a URDF file; fixed joints, and those whose limits are one angle that
/// is stated, become welds. A root link called "world" is a fixed base, any other one floats, and
/// so does what a floating joint holds to the root. Rotor inertia comes from transmissions as Drake
/// writes them (rotor_inertia, gear_ratio). What is read, left behind and refused:
/// urdf_vocabulary.cpp. Throws io::SpecError with all faults.
Imported read_urdf(const std::filesystem::path& file, const ImportFileOptions& options = {});

}  // namespace torquewright::hopper
