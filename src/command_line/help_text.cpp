// SPDX-License-Identifier: Apache-2.0
#include "src/command_line/help_text.hpp"

#include <fmt/format.h>

namespace torquewright::command_line {
namespace {

constexpr std::size_t kColumn = 30;  ///< In which meanings begin.

std::string entry(const std::string& name, const std::string& meaning) {
  const std::string left = "  " + name;
  if (left.size() + 2 <= kColumn) return fmt::format("{:<{}}{}\n", left, kColumn, meaning);
  return fmt::format("{}\n{:{}}{}\n", left, "", kColumn, meaning);
}

/// "-o, --output FILE"
std::string title(const DeclaredOption& option) {
  std::string text = fmt::format("{}", fmt::join(option.names, ", "));
  if (!option.is_argument && !option.value.empty()) text += " " + option.value;
  return text + (option.is_list ? " ..." : "");
}

std::string entries(const DeclaredCommand& command, bool are_arguments) {
  std::string text;
  for (const DeclaredOption& option : command.options) {
    if (option.is_argument == are_arguments) text += entry(title(option), meaning(option));
  }
  if (text.empty()) return "";
  return (are_arguments ? "\nArguments:\n" : "\nOptions:\n") + text;
}

}  // namespace

std::string help_text(const DeclaredCommand& command, const std::string& path) {
  std::string text = fmt::format("{}\n\nUsage: {}\n", command.help, usage(command, path));
  text += entries(command, true) + entries(command, false);
  if (!command.commands.empty()) text += "\nCommands:\n";
  for (const DeclaredCommand& each : command.commands) text += entry(each.name, each.help);
  if (!command.example.empty()) text += "\nExample:\n  " + command.example + "\n";
  return text;
}

}  // namespace torquewright::command_line
