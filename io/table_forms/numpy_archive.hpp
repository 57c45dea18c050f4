// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "io/table_forms/byte_source.hpp"

namespace torquewright::io {

/// Whether the file begins as a NumPy archive (.npz): a zip archive of .npy files.
bool begins_as_numpy_archive(std::string_view first_bytes);

/// Returns a NumPy archive's arrays as the text of one table (array_table.hpp), compressed or not,
/// row by row. `bytes` are those of the file of that name. Throws SpecError for an archive that is
/// damaged and one without arrays of numbers.
std::unique_ptr<ByteSource> numpy_archive(std::unique_ptr<ByteSource> bytes,
                                          const std::string& file);

}  // namespace torquewright::io
