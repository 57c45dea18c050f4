// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

namespace torquewright::io {

/// Writes the file whole or not at all: into a temporary file in the same folder, which then takes
/// the file's name. A link is followed; a pipe or a device is written to directly. Throws SpecError
/// with one fault if that is not possible (missing or read-only folder, the path is a folder, no
/// room); what stood there before then still stands there, and no temporary file is left.
void write_whole_file(const std::filesystem::path& file, std::string_view content);

/// Lets a write beyond the process's file size limit fail like any other write; by default the
/// system ends the process (SIGXFSZ). For the start of a program.
void ignore_file_size_signal();

}  // namespace torquewright::io
