// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/well_formed.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
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

/// Whether a text may hold it: RFC 3629's characters without those that XML 1.0 (2.2, Char) lacks.
bool is_legal(unsigned long code_point) {
  const bool is_surrogate = code_point >= 0xD800 && code_point <= 0xDFFF;
  const bool is_break = code_point == '\t' || code_point == '\n' || code_point == '\r';
  return !is_surrogate && code_point <= 0x10FFFF && (code_point >= 0x20 || is_break) &&
         code_point != 0xFFFE && code_point != 0xFFFF;
}

/// As RFC 3629, section 3 writes it.
std::string utf8(unsigned long code_point) {
  const auto tail = [&](unsigned shift) {
    return static_cast<char>(0x80U | ((code_point >> shift) & 0x3FU));
  };
  if (code_point < 0x80) return {static_cast<char>(code_point)};
  if (code_point < 0x800) return {static_cast<char>(0xC0U | (code_point >> 6U)), tail(0)};
  if (code_point < 0x10000) {
    return {static_cast<char>(0xE0U | (code_point >> 12U)), tail(6), tail(0)};
  }
  return {static_cast<char>(0xF0U | (code_point >> 18U)), tail(12), tail(6), tail(0)};
}

/// What a first byte says of the length, and its own bits; nothing else is looked at.
unsigned long read_character(std::string_view text, std::size_t length) {
  const auto lead = static_cast<unsigned char>(text[0]);
  unsigned long code_point = length == 1 ? lead : lead & (0x7FU >> length);
  for (std::size_t i = 1; i < length && i < text.size(); ++i) {
    code_point = code_point << 6U | (static_cast<unsigned char>(text[i]) & 0x3FU);
  }
  return code_point;
}

std::string at_line(std::string_view text, std::size_t place, const char* what) {
  std::size_t line = 1;
  for (const char character : text.substr(0, place)) line += character == '\n' ? 1U : 0U;
  std::array<char, 20> byte{};
  std::snprintf(byte.data(), byte.size(), "0x%02X",
                static_cast<unsigned>(static_cast<unsigned char>(text[place])));
  return std::string(what) + " begins with the byte " + byte.data() + " in line " +
         std::to_string(line);
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

std::string fault_of_characters_in(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const auto lead = static_cast<unsigned char>(text[at]);
    const std::size_t length = lead < 0xC0 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    const unsigned long code_point = read_character(text.substr(at), length);
    // What is read otherwise than it is written is no UTF-8: overlong, broken off, a stray byte.
    if (code_point > 0x10FFFF || text.substr(at, length) != utf8(code_point)) {
      return at_line(text, at, "what is no UTF-8");
    }
    if (!is_legal(code_point)) return at_line(text, at, "a character that no text may hold");
    at += length;
  }
  return "";
}

std::string fault_in(std::string_view text) {
  if (const std::string fault = fault_of_characters_in(text); !fault.empty()) return fault;
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
        if (name == "script") {  // what stands within is no markup (HTML, 4.12.1.3)
          const std::size_t close = text.find("</script", std::min(end, text.size()));
          if (close != std::string_view::npos) end = close;
        }
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
