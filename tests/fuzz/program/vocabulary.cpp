// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/program/vocabulary.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "tests/fuzz/program/runner.hpp"

namespace torquewright::fuzz {
namespace {

constexpr std::chrono::seconds kPatience{60};

struct Help {
  Words commands;
  std::vector<DeclaredOption> options;
};

Words words_of(const std::string& line) {
  std::istringstream stream(line);
  Words words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// Those after "one of ", which the entry's other lines may follow.
Words choices_in(const std::string& entry) {
  const std::string before = "one of ";
  const std::size_t begin = entry.find(before);
  if (begin == std::string::npos) return {};
  std::string list = entry.substr(begin + before.size());
  list = list.substr(0, list.find_first_of(";("));
  std::replace(list.begin(), list.end(), ',', ' ');
  return words_of(list);
}

/// As the help lists it: names, then in capitals what its value is, then its meaning.
DeclaredOption option_in(const std::string& entry) {
  const Words words = words_of(entry);
  std::size_t at = 0;
  while (words[at].ends_with(',')) ++at;  // -o, --output
  const Words kinds = {"TEXT", "NUMBER", "N", "WORD", "FILE"};
  const bool has_value =
      at + 1 < words.size() && std::find(kinds.begin(), kinds.end(), words[at + 1]) != kinds.end();
  return {words[at], has_value, has_value ? choices_in(entry) : Words{}};
}

Help help_of(const std::filesystem::path& program, Words command) {
  command.emplace_back("--help");
  const Circumstances here{program, ".", "/tmp", kPatience};
  std::istringstream lines(run(command, here).out);
  Help help;
  std::string section;
  std::vector<std::string> options;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) section.clear();
    if (line.empty()) continue;
    if (line.front() != ' ') section = line;
    const bool is_entry = line.size() > 2 && line.starts_with("  ") && line[2] != ' ';
    if (is_entry && section == "Commands:") help.commands.push_back(words_of(line)[0]);
    if (is_entry && section == "Options:") options.push_back(line);
    if (!is_entry && section == "Options:" && line.front() == ' ') options.back() += line;
  }
  for (const std::string& entry : options) {
    if (words_of(entry)[0] != "-h,") help.options.push_back(option_in(entry));
  }
  return help;
}

void add_commands(const std::filesystem::path& program, const Words& name,
                  std::vector<DeclaredCommand>& all) {
  const Help help = help_of(program, name);
  all.push_back({name, help.options});
  for (const std::string& each : help.commands) {
    Words inner = name;
    inner.push_back(each);
    add_commands(program, inner, all);
  }
}

}  // namespace

std::vector<DeclaredCommand> read_vocabulary(const std::filesystem::path& program) {
  std::vector<DeclaredCommand> all;
  add_commands(program, {}, all);
  if (all.size() < 2) throw std::runtime_error("the program's help lists no commands");
  return all;
}

}  // namespace torquewright::fuzz
