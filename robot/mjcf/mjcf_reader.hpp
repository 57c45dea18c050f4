// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "robot/draft/draft.hpp"
#include "robot/draft/import_options.hpp"

namespace torquewright::hopper {

/// Reads one tree of an MJCF file as MuJoCo's compiler does: includes, classes of defaults, frames,
/// mass by <inertial> or by shapes, hinges and slides. A free joint at its top floats; slides along
/// the world's x and z and a hinge about y there are a planar base; anything else stands on a fixed
/// base. Several joints in one body become as many bodies, all but the last without mass. What is
/// read, left behind and refused: mjcf_vocabulary.cpp. Throws io::SpecError with all faults.
Imported read_mjcf(const std::filesystem::path& file, const ImportFileOptions& options = {});

}  // namespace torquewright::hopper
