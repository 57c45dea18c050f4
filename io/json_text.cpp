// SPDX-License-Identifier: Apache-2.0
#include "io/json_text.hpp"

#include "io/json_builder.hpp"

namespace torquewright::io {

JsonText read_json_text(std::string_view text, const std::string& file) {
  if (text.empty()) return {nullptr, false, {{file, "", "is empty"}}};
  JsonBuilder builder(text, file);
  const bool complete = nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
  return builder.finish(complete);
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
