// SPDX-License-Identifier: Apache-2.0
#include "src/options/output_files.hpp"

#include <fmt/format.h>

#include "io/refusal.hpp"

namespace torquewright::cli {

std::vector<std::filesystem::path> named(std::initializer_list<std::string> files) {
  std::vector<std::filesystem::path> all;
  for (const std::string& file : files) {
    if (!file.empty()) all.emplace_back(file);
  }
  return all;
}

bool names_json(const std::string& file) {
  return std::filesystem::path(file).extension() == ".json";
}

void require_svg(const std::string& option, const std::string& file) {
  if (file.empty() || file == "-" || std::filesystem::path(file).extension() == ".svg") return;
  io::refuse(option, fmt::format("\"{}\" must end with .svg", file));
}

void add_output_options(command_line::Command& command, OutputFiles& files) {
  command.add_option("-o,--output", files.result, "Write the result as JSON to this file")
      .names_a_file();
  command.add_option("--draw", files.drawing, "Draw the gearbox to this SVG file").names_a_file();
}

}  // namespace torquewright::cli
