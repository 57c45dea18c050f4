// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

#include "io/table_forms/byte_source.hpp"

namespace torquewright::io {

/// Returns the text of a table: of a text file, of one that gzip compressed, of a NumPy archive
/// (.npz) or a MATLAB file (.mat), by the file's first bytes. Throws SpecError if the file is
/// missing, a folder or unreadable, and for archives that hold no table.
std::unique_ptr<ByteSource> table_bytes(const std::filesystem::path& file);

}  // namespace torquewright::io
