// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/shell_words.hpp"

#include <cstdio>
#include <memory>
#include <stdexcept>

#include "tests/io/scratch_folder.hpp"

namespace torquewright::cli_test {
namespace {

std::string line_with(const std::string& text, const std::string& start) {
  const std::size_t at = text.find(start);
  if (at == std::string::npos) throw std::runtime_error("no line has \"" + start + "\":\n" + text);
  const std::size_t from = at + start.size();
  return text.substr(from, text.find('\n', from) - from);
}

std::string printed_by(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  if (!pipe) throw std::runtime_error("no shell");
  std::string text;
  for (int letter = std::fgetc(pipe.get()); letter != EOF; letter = std::fgetc(pipe.get())) {
    text += static_cast<char>(letter);
  }
  return text;
}

}  // namespace

std::vector<std::string> suggested_words(const std::string& text, const std::string& start) {
  const test::ScratchFolder folder;
  const auto script = folder.write(
      "script", "torquewright() { for word do printf '%s\\0' \"$word\"; done; }\ntorquewright" +
                    line_with(text, start) + "\n");
  const std::string printed = printed_by("/bin/sh " + script.string());
  std::vector<std::string> words;
  for (std::size_t at = 0; at < printed.size();) {
    const std::size_t end = printed.find('\0', at);
    if (end == std::string::npos) throw std::runtime_error("a shell says: " + printed);
    words.push_back(printed.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

}  // namespace torquewright::cli_test
