// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace torquewright::io {

/// No document comes near this; a larger file is some other file.
constexpr std::size_t kMaxFileBytes = std::size_t{64} << 20;

/// The bytes of a file, a pipe or a device. Throws SpecError if it is missing, a folder, unreadable
/// or larger than kMaxFileBytes (a large file is refused before it is read).
std::string read_file_bytes(const std::filesystem::path& file);

}  // namespace torquewright::io
