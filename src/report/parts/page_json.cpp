// SPDX-License-Identifier: Apache-2.0
#include "src/report/parts/page_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace torquewright::report {

std::string json_in_page(const std::string& text) {
  std::string json =
      nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  for (const char character : {'<', '>', '&'}) {
    const std::string escape = fmt::format("\\u{:04x}", static_cast<int>(character));
    for (std::size_t at = json.find(character); at != std::string::npos;
         at = json.find(character, at)) {
      json.replace(at, 1, escape);
    }
  }
  return json;
}

}  // namespace torquewright::report
