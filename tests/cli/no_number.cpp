// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/no_number.hpp"

#include <cctype>
#include <string_view>

namespace torquewright::test {
namespace {

/// A page without the library that draws on it, whose own warnings speak of NaN.
std::string without_library(std::string page) {
  constexpr std::string_view kBegin = "<script>/* SPDX-License-Identifier: MIT";
  constexpr std::string_view kEnd = "</script>";
  const std::size_t begin = page.find(kBegin);
  if (begin == std::string::npos) return page;
  const std::size_t end = page.find(kEnd, begin);
  return end == std::string::npos ? page : page.erase(begin, end - begin);
}

}  // namespace

bool says_no_number(const std::string& whole) {
  const std::string text = without_library(whole);
  const auto is_alphanumeric = [&](std::size_t at) {
    return at < text.size() && std::isalnum(static_cast<unsigned char>(text[at])) != 0;
  };
  const auto is_letter = [&](std::size_t at) {
    if (at >= text.size()) return false;
    const bool is_inside_a_name = text[at] == '.' && is_alphanumeric(at + 1);  // inf.json
    return is_alphanumeric(at) || text[at] == '_' || text[at] == '-' || is_inside_a_name;
  };
  for (const std::string word : {"nan", "inf", "NaN", "Infinity"}) {
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
      const bool is_negative = at > 0 && text[at - 1] == '-' && (at < 2 || !is_letter(at - 2));
      const bool starts = at == 0 || is_negative || !is_letter(at - 1);
      if (starts && !is_letter(at + word.size())) return true;
    }
  }
  return false;
}

}  // namespace torquewright::test
