// SPDX-License-Identifier: Apache-2.0
#include "src/commands/gearbox_outputs.hpp"

#include <cstdio>
#include <vector>

#include "io/atomic_file.hpp"

namespace torquewright::cli {

void check_outputs(const OutputFiles& files, const std::string& input_file) {
  io::check_outputs(named({files.result, files.drawing}), {input_file});
  require_svg("--draw", files.drawing);
}

void write_outputs(const OutputFiles& files, const std::string& result,
                   const std::optional<std::string>& drawing) {
  std::vector<io::FileContent> contents;
  if (!files.result.empty()) contents.push_back({files.result, result});
  if (!files.drawing.empty() && drawing) contents.push_back({files.drawing, *drawing});
  io::write_whole_files(contents);
  if (files.drawing.empty() || drawing) return;
  std::fprintf(stderr, "%s: not written, there is no design to draw\n", files.drawing.c_str());
}

}  // namespace torquewright::cli
