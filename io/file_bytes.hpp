// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "io/file_limit.hpp"

namespace torquewright::io {

/// The bytes of a file, a pipe or a device. Throws SpecError if it is missing, a folder, unreadable
/// or larger than kMaxFileBytes (a large file is refused before it is read).
std::string read_file_bytes(const std::filesystem::path& file);

}  // namespace torquewright::io
