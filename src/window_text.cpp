// SPDX-License-Identifier: Apache-2.0
#include "src/window_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>

#include "io/documents/read_notes.hpp"
#include "io/text/one_line.hpp"
#include "src/held_output.hpp"
#include "src/loudness.hpp"
#include "src/verdict_colours.hpp"

namespace torquewright::cli {
namespace {

constexpr std::size_t kFewestColumns = 40;  ///< In fewer the window breaks lines itself.

/// Letters of UTF-8: bytes that begin one.
std::size_t letters(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char byte) { return (byte & 0xC0) != 0x80; }));
}

/// Where a line's text begins: behind the last two blanks in its first half, else behind its first
/// blanks.
std::size_t indent_of(const std::string& line, std::size_t columns) {
  const std::size_t first = line.find_first_not_of(' ');
  const std::size_t gap = line.substr(0, columns / 2).rfind("  ");
  return gap == std::string::npos || gap < first ? first : line.find_first_not_of(' ', gap);
}

std::string broken_line(const std::string& line, std::size_t columns) {
  const std::size_t indent = indent_of(line, columns);
  std::istringstream words(line.substr(indent));
  std::string text = line.substr(0, indent);
  std::size_t at = letters(text);
  const std::size_t begin = at;
  for (std::string word; words >> word;) {
    const std::size_t length = letters(word);
    if (at > begin && at + 1 + length > columns) {
      text += "\n" + std::string(begin, ' ') + word;
      at = begin + length;
    } else {
      text += at > begin ? " " + word : word;
      at += length + (at > begin ? 1 : 0);
    }
  }
  return text;
}

std::string first_line(const std::string& text) {
  const std::size_t begin = std::min(text.find_first_not_of('\n'), text.size());
  const std::size_t end = text.find('\n', begin);
  return text.substr(begin, end == std::string::npos ? end : end + 1 - begin);
}

/// The documents that were read, and what each says that nobody published or measured.
std::string assumptions_text() {
  std::string text;
  for (const io::ReadNote& note : io::read_notes()) {
    text += fmt::format(
        "read: {}, of kind {}; it assumes {}\n", io::one_line(note.file), note.kind,
        note.assumed.empty() ? "nothing" : fmt::format("{}", fmt::join(note.assumed, ", ")));
  }
  return text;
}

}  // namespace

std::size_t window_columns() {
  if (isatty(STDOUT_FILENO) != 1) return 0;
  winsize size{};
  return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

std::string broken_into(const std::string& text, std::size_t columns) {
  if (columns < kFewestColumns) return text;
  std::istringstream stream(text);
  std::string broken;
  for (std::string line; std::getline(stream, line);) {
    broken += (letters(line) > columns ? broken_line(line, columns) : line) + "\n";
  }
  return broken;
}

std::string for_window(const std::string& text, const std::string& answer) {
  std::string said = text;
  if (loudness().is_quiet) said = answer.empty() ? first_line(text) : answer + "\n";
  if (loudness().is_verbose) said += assumptions_text();
  if (held_output() != nullptr) return said;
  const std::string broken = broken_into(said, window_columns());
  return shows_colours() ? with_colours(broken) : broken;
}

}  // namespace torquewright::cli
