// SPDX-License-Identifier: Apache-2.0
#include "src/options/output_files.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "io/refusal.hpp"

namespace torquewright::cli {

bool names_json(const std::string& file) {
  return std::filesystem::path(file).extension() == ".json";
}

void require_svg(const std::string& option, const std::string& file) {
  if (file.empty() || std::filesystem::path(file).extension() == ".svg") return;
  io::refuse(option, fmt::format("\"{}\" must end with .svg", file));
}

void add_output_options(command_line::Command& command, OutputFiles& files) {
  command.add_option("-o,--output", files.result, "Write the result as JSON here").names_a_file();
  command.add_option("--draw", files.drawing, "Draw the gearbox to this SVG file").names_a_file();
}

}  // namespace torquewright::cli
