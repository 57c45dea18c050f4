// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

#include "src/command_line/command_line.hpp"

namespace torquewright::cli {

/// The files a gearbox command was asked to write beside its stdout; an empty name: not asked for.
struct OutputFiles {
  std::string result;
  std::string drawing;
};

/// Returns those of the names that are not empty.
std::vector<std::filesystem::path> named(std::initializer_list<std::string> files);

/// A file whose ending asks for JSON.
bool names_json(const std::string& file);

/// Throws io::SpecError where a drawing's ending is another picture's than what is drawn.
void require_svg(const std::string& option, const std::string& file);

/// Throws io::SpecError where a page's ending is that of another kind of file.
void require_page(const std::string& option, const std::string& file);

/// Throws io::SpecError where an output would be among the candidates of that folder, which the
/// next run reads. An empty folder's name: there are none.
void require_outside(const std::string& folder, const std::vector<std::filesystem::path>& outputs);

/// Adds -o and --draw, which say where to.
void add_output_options(command_line::Command& command, OutputFiles& files);

}  // namespace torquewright::cli
