// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "robot/xml/xml.hpp"

namespace torquewright::hopper {

/// The root element of an MJCF file with the content of the files that <include> names in their
/// place. Each is named from the main file's folder, or else from that of the file that names it,
/// and stands once. Faults where one is named by an absolute path, twice, or is not there.
Element read_with_includes(const std::filesystem::path& file, Faults& faults);

}  // namespace torquewright::hopper
