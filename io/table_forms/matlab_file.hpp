// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "io/table_forms/byte_source.hpp"

namespace torquewright::io {

/// Whether the file begins as MATLAB writes them since version 5 (with -v7.3 an HDF5 file).
bool begins_as_matlab_file(std::string_view first_bytes);

/// Returns a MATLAB file's arrays, fields of structs among them (s.q), as the text of one table
/// (array_table.hpp). They are read by the library matio, which is loaded when it is asked for, and
/// held in memory. `bytes` are those of the file of that name. Throws SpecError where matio is not
/// installed, for a file that it cannot read and for one without arrays of numbers.
std::unique_ptr<ByteSource> matlab_file(std::unique_ptr<ByteSource> bytes, const std::string& file);

}  // namespace torquewright::io
