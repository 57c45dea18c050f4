// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "src/options/output_files.hpp"

namespace torquewright::cli {

/// Checks before the work that files can be written: throws SpecError if one cannot, or is the
/// input.
void check_outputs(const OutputFiles& files, const std::string& input_file);

/// Writes what was asked for, all of it or nothing, and prints `printed` unless a file is "-".
/// Where there is no drawing (no design) its file stays as it is, which is said on stderr.
void write_outputs(const OutputFiles& files, const std::string& result,
                   const std::optional<std::string>& drawing, const std::string& printed);

}  // namespace torquewright::cli
