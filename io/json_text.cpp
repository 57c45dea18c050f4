// SPDX-License-Identifier: Apache-2.0
#include "io/json_text.hpp"

#include <nlohmann/json.hpp>

#include "io/json_builder.hpp"
#include "io/syntax_fault.hpp"

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

std::string json_text(const nlohmann::ordered_json& document, int indent) {
  return document.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string child_path(const std::string& path, std::string_view key) {
  std::string child = path + '/';
  for (const char character : key) {
    if (character == '~') {
      child += "~0";
    } else if (character == '/') {
      child += "~1";
    } else {
      child += character;
    }
  }
  return child;
}

}  // namespace torquewright::io
