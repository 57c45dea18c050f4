// SPDX-License-Identifier: Apache-2.0
#include "src/command_line/declaration.hpp"

#include <algorithm>

#include "io/wording.hpp"

namespace torquewright::command_line {
namespace {

using Visit = std::function<void(const DeclaredCommand&, const std::string&)>;

void visit_below(const DeclaredCommand& command, const std::string& words, const Visit& visit) {
  visit(command, words);
  for (const DeclaredCommand& each : command.commands) {
    visit_below(each, words.empty() ? each.name : words + " " + each.name, visit);
  }
}

}  // namespace

void for_each_command(const DeclaredCommand& program, const Visit& visit) {
  visit_below(program, "", visit);
}

const DeclaredCommand* find_command(const DeclaredCommand& command, std::string_view name) {
  for (const DeclaredCommand& each : command.commands) {
    if (each.name == name) return &each;
  }
  return nullptr;
}

const DeclaredOption* find_option(const DeclaredCommand& command, std::string_view name) {
  for (const DeclaredOption& option : command.options) {
    if (option.is_argument) continue;
    if (std::find(option.names.begin(), option.names.end(), name) != option.names.end()) {
      return &option;
    }
  }
  return nullptr;
}

const std::string& longest_name(const DeclaredOption& option) {
  return *std::max_element(option.names.begin(), option.names.end(),
                           [](const auto& a, const auto& b) { return a.size() < b.size(); });
}

std::string meaning(const DeclaredOption& option) {
  std::string text = option.help;
  const std::string each = option.is_list ? "each " : "";
  if (!option.choices.empty()) text += "; " + each + "one of " + io::listed(option.choices);
  if (!option.range.empty()) text += "; " + each + option.range;
  if (option.has_commas) text += "; separated by commas";
  if (option.is_repeated) text += "; may be named several times";
  if (!option.needs.empty()) text += "; only with " + io::listed(option.needs);
  if (!option.excludes.empty()) text += "; not with " + io::either(option.excludes);
  if (option.writes_file && !option.is_never_printed && longest_name(option) == "--output") {
    text += "; - is standard output";
  }
  if (option.is_required) text += "; required";
  if (!option.otherwise.empty()) text += " (default: " + option.otherwise + ")";
  return text;
}

std::string usage(const DeclaredCommand& command, const std::string& path) {
  std::string text = path + " [OPTIONS]";
  for (const DeclaredOption& option : command.options) {
    if (!option.is_argument) continue;
    const std::string word = option.names.front() + (option.is_list ? "..." : "");
    text += option.is_required ? " " + word : " [" + word + "]";
  }
  if (!command.commands.empty()) text += command.needs_command ? " COMMAND" : " [COMMAND]";
  return text;
}

}  // namespace torquewright::command_line
