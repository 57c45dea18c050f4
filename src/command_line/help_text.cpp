// SPDX-License-Identifier: Apache-2.0
#include "src/command_line/help_text.hpp"

#include <fmt/format.h>

#include <sstream>

namespace torquewright::command_line {
namespace {

constexpr std::size_t kColumn = 26;  ///< In which meanings begin.
constexpr std::size_t kWidth = 80;   ///< Of the narrowest window in which lines stay whole.

/// Words of the text in lines that end before kWidth, each but the first behind `indent` blanks.
/// The first stands behind what fills that column already.
std::string wrapped(const std::string& text, std::size_t indent) {
  std::istringstream stream(text);
  std::string lines;
  std::size_t at = indent;
  for (std::string word; stream >> word;) {
    const bool is_first = at == indent;
    if (!is_first && at + 1 + word.size() > kWidth) {
      lines += "\n" + std::string(indent, ' ') + word;
      at = indent + word.size();
    } else {
      lines += (is_first ? "" : " ") + word;
      at += word.size() + (is_first ? 0 : 1);
    }
  }
  return lines;
}

std::string entry(const std::string& name, const std::string& meaning) {
  const std::string left = "  " + name, lines = wrapped(meaning, kColumn);
  if (left.size() + 2 <= kColumn) return fmt::format("{:<{}}{}\n", left, kColumn, lines);
  return fmt::format("{}\n{:{}}{}\n", left, "", kColumn, lines);
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
  std::string text =
      fmt::format("{}\n\nUsage: {}\n", wrapped(command.help, 0), usage(command, path));
  text += entries(command, true) + entries(command, false);
  if (!command.commands.empty()) text += "\nCommands:\n";
  for (const DeclaredCommand& each : command.commands) text += entry(each.name, each.help);
  if (!command.example.empty()) text += "\nExample:\n  " + command.example + "\n";
  return text;
}

}  // namespace torquewright::command_line
