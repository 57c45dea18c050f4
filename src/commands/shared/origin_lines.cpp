// SPDX-License-Identifier: Apache-2.0
#include "src/commands/shared/origin_lines.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/documents/provenance.hpp"
#include "io/text/one_line.hpp"

namespace torquewright::cli {

std::vector<std::string> origin_of(std::string_view command,
                                   std::span<const io::Document> documents) {
  std::vector<std::string> lines{
      fmt::format("Written by torquewright {}, {}, from:", io::tool_version(), command)};
  for (const io::Document& document : documents) {
    const std::string line =
        fmt::format("{} sha256 {}", io::name_in_text(document.file), document.sha256);
    // Drives of one kind name one file.
    if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
  }
  return lines;
}

}  // namespace torquewright::cli
