// SPDX-License-Identifier: Apache-2.0
#include "src/options/output_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <system_error>

#include "io/faults/refusal.hpp"

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

void require_page(const std::string& option, const std::string& file) {
  constexpr std::array kOthers{".json", ".csv", ".svg", ".png",  ".pdf",
                               ".txt",  ".md",  ".xml", ".urdf", ".yaml"};
  const std::filesystem::path ending = std::filesystem::path(file).extension();
  if (std::find(kOthers.begin(), kOthers.end(), ending) == kOthers.end()) return;
  io::refuse(option, fmt::format("\"{}\" becomes a page, and must end with .html", file));
}

void require_outside(const std::string& folder, const std::vector<std::filesystem::path>& outputs) {
  if (folder.empty()) return;
  for (const std::filesystem::path& output : outputs) {
    std::error_code unknown;
    const std::filesystem::path in = std::filesystem::absolute(output).parent_path();
    if (output.extension() != ".json" || !std::filesystem::equivalent(in, folder, unknown)) {
      continue;
    }
    io::refuse_output(output,
                      "it would be one of the candidates of the next run; write it into "
                      "another folder");
  }
}

void add_output_options(command_line::Command& command, OutputFiles& files) {
  command.add_option("-o,--output", files.result, "Write the result as JSON to this file")
      .names_a_file();
  command.add_option("--draw", files.drawing, "Draw the gearbox to this SVG file").names_a_file();
}

}  // namespace torquewright::cli
