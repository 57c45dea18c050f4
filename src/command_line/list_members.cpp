// SPDX-License-Identifier: Apache-2.0
#include "src/command_line/list_members.hpp"

#include <fmt/format.h>

#include "src/command_line/misspelling.hpp"

namespace torquewright::command_line {
namespace {

bool has_empty_member(const std::string& list) {
  return list.starts_with(',') || list.ends_with(',') || list.find(",,") != std::string::npos;
}

}  // namespace

std::optional<std::string> empty_member(const DeclaredCommand& program,
                                        std::span<const std::string> words) {
  const DeclaredCommand* command = &program;
  const DeclaredOption* list = nullptr;  // whose values the words are
  for (const std::string& word : words) {
    if (word == "--") break;
    std::string value = word;
    if (is_option(word)) {
      list = find_option(*command, name_in(word));
      if (list != nullptr && list->value.empty()) list = nullptr;  // a flag
      const std::size_t equals = word.find('=');
      if (equals == std::string::npos || !word.starts_with("--")) continue;
      value = word.substr(equals + 1);
    } else if (list == nullptr) {
      if (const DeclaredCommand* next = find_command(*command, word)) command = next;
      continue;
    }
    if (list == nullptr) continue;
    if (list->has_commas && has_empty_member(value)) {
      return fmt::format("{}: \"{}\" has an empty member", longest_name(*list), value);
    }
    if (!list->is_list || list->is_repeated || is_option(word)) list = nullptr;
  }
  return std::nullopt;
}

}  // namespace torquewright::command_line
