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

/// "-o,--output" is --output.
std::string longest_name(const std::string& names) {
  const std::size_t dashes = names.find("--");
  const std::string name = dashes == std::string::npos ? names : names.substr(dashes);
  return name.substr(0, name.find(','));
}

/// Those in "TEXT:{a,b}".
Words choices_in(const std::string& type) {
  const std::size_t open = type.find('{');
  if (open == std::string::npos) return {};
  std::string list = type.substr(open + 1, type.find('}') - open - 1);
  std::replace(list.begin(), list.end(), ',', ' ');
  return words_of(list);
}

/// As CLI11 lists it: names, then the type of the value in capitals, then the help.
DeclaredOption option_in(const Words& line) {
  const auto is_type = [](const std::string& word) {
    for (const std::string type : {"TEXT", "FLOAT", "INT", "UINT"}) {
      if (word.starts_with(type)) return true;
    }
    return false;
  };
  const bool has_value = line.size() > 1 && is_type(line[1]);
  return {longest_name(line[0]), has_value, has_value ? choices_in(line[1]) : Words{}};
}

Help help_of(const std::filesystem::path& program, Words command) {
  command.emplace_back("--help");
  const Circumstances here{program, ".", "/tmp", kPatience};
  std::istringstream lines(run(command, here).out);
  Help help;
  std::string section;
  for (std::string line; std::getline(lines, line);) {
    const Words words = words_of(line);
    if (words.empty()) section.clear();
    if (words.empty()) continue;
    if (line.front() != ' ') section = line;
    const bool is_entry = line.size() > 2 && line.starts_with("  ") && line[2] != ' ';
    if (is_entry && section == "Subcommands:") help.commands.push_back(words[0]);
    const bool is_option = is_entry && words[0].front() == '-';
    if (is_option && words[0] != "-h,--help") help.options.push_back(option_in(words));
  }
  return help;
}

void add_commands(const std::filesystem::path& program, const Words& name,
                  std::vector<DeclaredCommand>& all) {
  const Help help = help_of(program, name);
  if (name.size() > 1 || !help.commands.empty()) all.push_back({name, help.options});
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
