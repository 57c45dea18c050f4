// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace torquewright::io {

/// Writes the file whole or not at all: into a temporary file in the same folder, which then takes
/// the file's name. A link is followed; a pipe, a device or one of the process's own descriptors
/// (/dev/stdout) is written into. Throws SpecError with one fault if that is not possible (missing
/// or read-only folder, the path is a folder, no room); what stood there before then still stands
/// there, and no temporary file is left.
void write_whole_file(const std::filesystem::path& file, std::string_view content);

/// A file to be written, and what into it.
struct FileContent {
  std::filesystem::path file;
  std::string content;
};

/// Writes all of the files as write_whole_file does, or none: each one stands complete under its
/// temporary name before the first takes its own.
void write_whole_files(const std::vector<FileContent>& files);

/// Checks files before the work that makes their content: throws SpecError with a fault for each of
/// `outputs` that cannot be written, is one of `inputs`, or stands twice. Changes no file.
void check_outputs(const std::vector<std::filesystem::path>& outputs,
                   const std::vector<std::filesystem::path>& inputs);

/// Lets a write beyond the process's file size limit fail like any other write; by default the
/// system ends the process (SIGXFSZ). For the start of a program.
void ignore_file_size_signal();

}  // namespace torquewright::io
