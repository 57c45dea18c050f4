// SPDX-License-Identifier: Apache-2.0
#include "src/command_line/misspelling.hpp"

#include <fmt/format.h>

#include <cctype>
#include <vector>

#include "io/text/nearest.hpp"
#include "io/text/wording.hpp"

namespace torquewright::command_line {
namespace {

/// --top of --top=3, -o of -oFILE.
std::string name_in(const std::string& word) {
  return word.starts_with("--") ? word.substr(0, word.find('=')) : word.substr(0, 2);
}

/// The words behind the program's own name.
std::string without_program(const std::string& path) {
  const std::size_t blank = path.find(' ');
  return blank == std::string::npos ? "" : path.substr(blank + 1);
}

/// The option that was meant: --at-speed for --speed, --bus-voltage for --bus-votage.
std::optional<std::string> meant_option(const DeclaredCommand& command, const std::string& name) {
  constexpr std::size_t kTellingLetters = 4;
  std::vector<std::string> known;
  std::optional<std::string> holds_it;
  if (!name.starts_with("--")) return std::nullopt;
  const std::string stem = name.substr(2);
  for (const DeclaredOption& option : command.options) {
    if (option.is_argument) continue;
    const std::string& each = longest_name(option);
    known.push_back(each);
    if (stem.size() < kTellingLetters || each.find(stem) == std::string::npos) continue;
    if (!holds_it || each.size() < holds_it->size()) holds_it = each;
  }
  return holds_it ? holds_it : io::nearest(name, known);
}

std::string unknown_option(const DeclaredCommand& program, const Reached& where,
                           const std::string& name) {
  const std::string command = without_program(where.path);
  const std::string what =
      fmt::format("unknown option {}{}", name, command.empty() ? "" : " of " + command);
  std::vector<std::string> owners;
  for_each_command(program, [&](const DeclaredCommand& each, const std::string& path) {
    if (find_option(each, name)) owners.push_back(path);
  });
  if (!owners.empty()) return what + "; it is one of " + io::either(owners);
  const auto meant = meant_option(*where.command, name);
  return meant ? fmt::format("{}; did you mean {}?", what, *meant) : what;
}

}  // namespace

bool is_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-' &&
         std::isdigit(static_cast<unsigned char>(word[1])) == 0 && word[1] != '.';
}

std::string unknown_command(const DeclaredCommand& program, const Reached& where,
                            const std::string& word) {
  const std::string what = fmt::format("unknown command \"{}\"", word);
  std::vector<std::string> here, elsewhere;
  for (const DeclaredCommand& each : where.command->commands) here.push_back(each.name);
  if (const auto near = io::nearest(word, here)) {
    const std::string before = without_program(where.path);
    return fmt::format("{}; did you mean {}{}{}?", what, before, before.empty() ? "" : " ", *near);
  }
  std::string meant;
  for_each_command(program, [&](const DeclaredCommand& each, const std::string& path) {
    if (!each.name.empty() && io::nearest(word, std::vector{each.name}) && !path.empty()) {
      if (each.name == word || meant.empty()) meant = path;
    }
  });
  if (!meant.empty()) return fmt::format("{}; did you mean {}?", what, meant);
  if (here.empty()) return fmt::format("{}; {} has none below it", what, where.path);
  return fmt::format("{}; there are {}", what, io::listed(here));
}

Reached reached_by(const DeclaredCommand& program, std::span<const std::string> words) {
  Reached reached{&program, program.name, 0};
  for (; reached.rest < words.size(); ++reached.rest) {
    const std::string& word = words[reached.rest];
    if (is_option(word)) continue;
    const DeclaredCommand* next = find_command(*reached.command, word);
    if (!next) break;
    reached.command = next;
    reached.path += " " + word;
  }
  return reached;
}

std::optional<std::string> misspelling(const DeclaredCommand& program,
                                       std::span<const std::string> words) {
  Reached where{&program, program.name, 0};
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word == "--") break;
    if (is_option(word)) {
      const std::string name = name_in(word);
      const DeclaredOption* option = find_option(*where.command, name);
      if (!option) return unknown_option(program, where, name);
      if (!option->value.empty() && name == word) ++i;  // its value stands in the next word
      continue;
    }
    const DeclaredCommand* next = find_command(*where.command, word);
    if (next) where = {next, where.path + " " + word, i + 1};
    if (!next && where.command->needs_command) return unknown_command(program, where, word);
  }
  return std::nullopt;
}

}  // namespace torquewright::command_line
