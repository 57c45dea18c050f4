// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "io/files/file_limit.hpp"

namespace torquewright::io {

/// The bytes of a file, a pipe or a device. Throws SpecError if it is missing, a folder, unreadable
/// or larger than kMaxFileBytes (a large file is refused before it is read).
std::string read_file_bytes(const std::filesystem::path& file);

/// Whether its bytes are those; of a file of any length. Throws as read_file_bytes does.
bool holds(const std::filesystem::path& file, std::string_view content);

}  // namespace torquewright::io
