// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/no_number.hpp"

#include <cctype>

namespace torquewright::test {

bool says_no_number(const std::string& text) {
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
