// SPDX-License-Identifier: Apache-2.0
#include "io/documents/json_reader.hpp"

#include <nlohmann/json.hpp>

#include "io/documents/json_builder.hpp"
#include "io/faults/syntax_fault.hpp"

namespace torquewright::io {

JsonText read_json_text(std::string_view text, const std::string& file) {
  if (text.empty()) return {nullptr, false, {{file, "", "is empty"}}};
  // The parser takes a zero byte for the end of the text and would not see what follows.
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
    return {
        nullptr, false, {{file, "", line_and_column(text, zero + 1) + ": not JSON: zero byte"}}};
  }
  JsonBuilder builder(text, file);
  const bool complete = nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
  return builder.finish(complete);
}

}  // namespace torquewright::io
