// SPDX-License-Identifier: Apache-2.0
#include "src/report/parts/shell_word.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace torquewright::report {

std::string shell_word(const std::string& word) {
  constexpr std::string_view kPlainSigns = "._/-+=:,@%";
  const bool is_plain =
      !word.empty() && std::all_of(word.begin(), word.end(), [&](unsigned char letter) {
        return std::isalnum(letter) != 0 ||
               kPlainSigns.find(static_cast<char>(letter)) != std::string_view::npos;
      });
  if (is_plain) return word;
  std::string text = "'";
  for (const char letter : word)
    text += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return text + "'";
}

}  // namespace torquewright::report
