// SPDX-License-Identifier: Apache-2.0
#include "tests/packages/shell.hpp"

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace torquewright::packages_test {

namespace fs = std::filesystem;

Said said_by(const std::string& line, const fs::path& folder) {
  const std::string whole = "cd " + sh_word(folder) + " && {\n" + line + "\n} 2>&1 </dev/null";
  FILE* pipe = popen(whole.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("no shell");
  Said said;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
    said.text.append(buffer.data(), count);
  }
  const int status = pclose(pipe);
  if (WIFEXITED(status)) said.exit_code = WEXITSTATUS(status);
  return said;
}

std::string text_by(const std::string& line, const fs::path& folder) {
  Said said = said_by(line, folder);
  if (said.exit_code != 0) throw std::runtime_error(line + "\n" + said.text);
  return std::move(said.text);
}

std::string sh_word(const fs::path& word) {
  std::string text = "'";
  for (const char letter : word.string()) {
    text += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  }
  return text + "'";
}

std::string missing_programs(const std::vector<std::string>& programs) {
  std::string missing;
  for (const std::string& program : programs) {
    if (said_by("command -v " + program).exit_code != 0) missing += " " + program;
  }
  return missing;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error(file.string() + " is not there");
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> files_below(const fs::path& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_directory()) files.push_back(entry.path().lexically_relative(folder).string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

namespace {

void append_below(const fs::path& program, const std::string& words,
                  std::vector<std::string>& commands) {
  commands.push_back(words);
  bool is_listed = false;
  for (const std::string& line : lines_of(text_by(sh_word(program) + " " + words + " --help"))) {
    if (line.empty()) is_listed = false;
    if (is_listed && line.starts_with("  ") && line[2] != ' ') {
      const std::string name = line.substr(2, line.find(' ', 2) - 2);
      append_below(program, words.empty() ? name : words + " " + name, commands);
    }
    if (line == "Commands:") is_listed = true;
  }
}

}  // namespace

std::vector<std::string> commands_of(const fs::path& program) {
  std::vector<std::string> commands;
  append_below(program, "", commands);
  return commands;
}

}  // namespace torquewright::packages_test
