// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/well_formed.hpp"

#include <set>
#include <vector>

namespace torquewright::cli_test {
namespace {

/// Position behind `end`, from `at` on; npos where it is missing.
std::size_t behind(std::string_view text, std::size_t at, std::string_view end) {
  const std::size_t found = text.find(end, at);
  return found == std::string_view::npos ? found : found + end.size();
}

/// Position behind the tag that begins at `at`; a '>' within quotes does not end it.
std::size_t behind_tag(std::string_view text, std::size_t at) {
  char quote = 0;
  for (; at < text.size(); ++at) {
    const char character = text[at];
    if (quote != 0) {
      if (character == quote) quote = 0;
    } else if (character == '"' || character == '\'') {
      quote = character;
    } else if (character == '>') {
      return at + 1;
    }
  }
  return std::string_view::npos;
}

std::string_view id_of(std::string_view tag) {
  for (const std::string_view key : {" id=\"", " id='"}) {
    const std::size_t at = tag.find(key);
    if (at == std::string_view::npos) continue;
    const std::size_t begin = at + key.size();
    return tag.substr(begin, tag.find(key.back(), begin) - begin);
  }
  return {};
}

}  // namespace

std::string fault_in(std::string_view text) {
  std::vector<std::string> open;
  std::set<std::string, std::less<>> ids;
  std::size_t at = text.find('<');
  while (at != std::string_view::npos) {
    std::size_t end = 0;
    if (text.substr(at, 4) == "<!--") {
      end = behind(text, at, "-->");
    } else if (text.substr(at, 9) == "<![CDATA[") {
      end = behind(text, at, "]]>");
    } else {
      end = behind_tag(text, at);
      const std::string tag(text.substr(at, end == std::string_view::npos ? 40 : end - at));
      const std::string name = tag.substr(1, tag.find_first_of(" \t\r\n/>", 2) - 1);
      if (tag[1] == '/') {
        if (open.empty() || "/" + open.back() != name) return "closed out of turn: " + tag;
        open.pop_back();
      } else if (tag[1] != '!' && tag[1] != '?' && !tag.ends_with("/>")) {
        open.push_back(name);
      }
      const std::string_view id = id_of(tag);
      if (!id.empty() && !ids.emplace(id).second) return "stands twice: " + std::string(id);
    }
    if (end == std::string_view::npos) return "not ended: " + std::string(text.substr(at, 40));
    at = text.find('<', end);
  }
  return open.empty() ? "" : "not closed: " + open.back();
}

}  // namespace torquewright::cli_test
