// SPDX-License-Identifier: Apache-2.0
#include "src/command_line/declaration.hpp"

#include <algorithm>
#include <cctype>

#include "io/text/wording.hpp"

namespace torquewright::command_line {
namespace {

using Visit = std::function<void(const DeclaredCommand&, const std::string&)>;

void visit_below(const DeclaredCommand& command, const std::string& words, const Visit& visit) {
  visit(command, words);
  for (const DeclaredCommand& each : command.commands) {
    visit_below(each, words.empty() ? each.name : words + " " + each.name, visit);
  }
}

bool names(const std::string& text, const std::string& word) {
  const auto ends_word = [&text](std::size_t at) {
    return at >= text.size() ||
           (std::isalnum(static_cast<unsigned char>(text[at])) == 0 && text[at] != '-');
  };
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    if ((at == 0 || ends_word(at - 1)) && ends_word(at + word.size())) return true;
  }
  return false;
}

/// Whether the text says each of the words already.
bool names_all(const std::string& text, const std::vector<std::string>& words) {
  return std::all_of(words.begin(), words.end(),
                     [&text](const std::string& word) { return names(text, word); });
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
  if (!names_all(option.help, option.choices)) {
    text += "; " + each + "one of " + io::listed(option.choices);
  }
  if (!option.range.empty()) text += "; " + each + option.range;
  if (option.has_commas) text += "; separated by commas";
  if (option.is_repeated) text += "; may be named several times";
  if (!option.needs.empty()) text += "; only with " + io::listed(option.needs);
  if (!option.excludes.empty()) text += "; not with " + io::either(option.excludes);
  const bool may_be_printed = option.writes_file && !option.is_never_printed;
  if (may_be_printed && longest_name(option) == "--output" && option.otherwise.empty()) {
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
