// SPDX-License-Identifier: Apache-2.0
#include "src/command_line/blank_value.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/command_line/misspelling.hpp"

namespace torquewright::command_line {
namespace {

bool is_blank(std::string_view text) { return text.find_first_not_of(" \t") == text.npos; }

bool has_blank_place(std::string_view list) {
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    if (is_blank(list.substr(begin, end - begin))) return true;
    begin = end + 1;
  }
  return false;
}

std::optional<std::string> fault_of(const DeclaredOption& option, const std::string& value) {
  const std::string& name = longest_name(option);
  if (is_blank(value)) return fmt::format("{}: \"{}\" is blank", name, value);
  if (!option.has_commas || !has_blank_place(value)) return std::nullopt;
  return fmt::format("{}: \"{}\" has a blank place in its list", name, value);
}

}  // namespace

std::optional<std::string> blank_value(const DeclaredCommand& program,
                                       std::span<const std::string> words) {
  const DeclaredCommand& command = *reached_by(program, words).command;
  for (std::size_t i = 0; i < words.size() && words[i] != "--"; ++i) {
    const std::size_t equals = words[i].find('=');
    const DeclaredOption* option = find_option(command, words[i].substr(0, equals));
    if (!option || option->is_argument || option->value.empty()) continue;
    if (equals == std::string::npos && ++i == words.size()) break;
    const std::string value = equals == std::string::npos ? words[i] : words[i].substr(equals + 1);
    if (equals == std::string::npos && value.starts_with("--") && find_option(command, value)) {
      return fmt::format("{}: its value is missing, {} is an option; {}={} would take it as one",
                         longest_name(*option), value, longest_name(*option), value);
    }
    if (const auto fault = fault_of(*option, value)) return fault;
    const bool goes_on = option->is_list && !option->is_repeated && equals == std::string::npos;
    while (goes_on && i + 1 < words.size() && !is_option(words[i + 1])) {
      if (const auto fault = fault_of(*option, words[++i])) return fault;
    }
  }
  return std::nullopt;
}

}  // namespace torquewright::command_line
