// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/files/atomic_file.hpp"

namespace torquewright::cli {

/// Writes a command's result to stdout. Throws SpecError if not all of it gets there.
void print_result(const std::string& text);

/// The name of a file by which the user asks for standard output: "-". A file that is called so is
/// "./-".
bool is_standard_output(const std::filesystem::path& file);

/// Throws SpecError where one of the outputs could not be written, as io::check_outputs; standard
/// output counts as writable.
void check_written(std::vector<std::filesystem::path> outputs,
                   const std::vector<std::filesystem::path>& inputs);

/// Writes all files or none; then one that is called "-", or else the text, to standard output.
void deliver(std::vector<io::FileContent> files, const std::string& text);

/// The result itself, for commands whose -o takes the place of standard output: to that file, or
/// where none was named to standard output. All or none with the files beside it.
void deliver_result(const std::string& text, const std::string& file,
                    std::vector<io::FileContent> beside = {});

/// A result in both of its shapes.
struct Report {
  std::string json;         ///< The document.
  std::string text;         ///< For people.
  std::string answer = {};  ///< What -q leaves of the text; empty: its first line.
};

/// The document to the file of -o, where one was named, and the text beside it to standard output,
/// where --json puts the document too. A file that does not end with .json gets the text in this
/// version, which is said, and standard output nothing. All or none with the files beside it.
void deliver_report(const Report& report, const std::string& file, bool json_wanted,
                    std::vector<io::FileContent> beside = {});

/// One sentence on stderr: -o still writes what `instead` is for, in this version.
void say_old_spelling(const std::string& file, const std::string& what, const std::string& instead);

}  // namespace torquewright::cli
