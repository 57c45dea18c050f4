// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "src/command_line/command_line.hpp"

namespace torquewright::cli {

/// The files a gearbox command was asked to write beside its stdout; an empty name: not asked for.
struct OutputFiles {
  std::string result;
  std::string drawing;
};

/// Adds -o and --draw, which say where to.
void add_output_options(command_line::Command& command, OutputFiles& files);

/// For before the work. Throws SpecError if a file cannot be written or is the input.
void check_outputs(const OutputFiles& files, const std::string& input_file);

/// Writes what was asked for, all of it or nothing. Where there is no drawing (no design) its file
/// stays as it is, which is said on stderr.
void write_outputs(const OutputFiles& files, const std::string& result,
                   const std::optional<std::string>& drawing);

}  // namespace torquewright::cli
