// SPDX-License-Identifier: Apache-2.0
#include "src/command_line/repeated_option.hpp"

#include <fmt/format.h>

#include <map>

#include "src/command_line/misspelling.hpp"

namespace torquewright::command_line {

std::optional<std::string> repeated_option(const DeclaredCommand& program,
                                           std::span<const std::string> words) {
  const DeclaredCommand& command = *reached_by(program, words).command;
  std::map<const DeclaredOption*, std::string> seen;
  for (std::size_t i = 0; i < words.size() && words[i] != "--"; ++i) {
    const std::string name = words[i].substr(0, words[i].find('='));
    const DeclaredOption* option = find_option(command, name);
    if (!option || option->is_argument || option->is_list || option->value.empty()) continue;
    const auto [first, is_new] = seen.emplace(option, name);
    if (!is_new && first->second == name) return fmt::format("{} is given twice; give one", name);
    if (!is_new) {
      return fmt::format("{} and {} are one option; give one of them", first->second, name);
    }
    if (name == words[i]) ++i;  // its value stands in the next word
  }
  return std::nullopt;
}

}  // namespace torquewright::command_line
