// SPDX-License-Identifier: Apache-2.0
#include "src/commands/gearbox/gearbox_outputs.hpp"

#include <cstdio>
#include <utility>
#include <vector>

#include "io/files/atomic_file.hpp"
#include "src/standard_output.hpp"

namespace torquewright::cli {

void check_outputs(const OutputFiles& files, const std::string& input_file) {
  check_written(named({files.result, files.drawing}), {input_file});
  require_svg("--draw", files.drawing);
}

void write_outputs(const OutputFiles& files, const std::string& result,
                   const std::optional<std::string>& drawing, const std::string& printed) {
  std::vector<io::FileContent> contents;
  if (!files.result.empty()) contents.push_back({files.result, result});
  if (!files.drawing.empty() && drawing) contents.push_back({files.drawing, *drawing});
  deliver(std::move(contents), printed);
  if (files.drawing.empty() || drawing) return;
  std::fprintf(stderr, "%s: not written, there is no design to draw\n", files.drawing.c_str());
}

}  // namespace torquewright::cli
