// SPDX-License-Identifier: Apache-2.0
#include "io/faults/json_text.hpp"

#include <nlohmann/json.hpp>

namespace torquewright::io {

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
