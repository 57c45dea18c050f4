// SPDX-License-Identifier: Apache-2.0
#include "io/files/table_begin.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <vector>

namespace torquewright::io {
namespace {

constexpr std::size_t kLooksAtLines = 200;
constexpr std::size_t kLongestLine = 1 << 16;
constexpr std::size_t kShownLetters = 60;

std::vector<std::string> first_lines(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::vector<std::string> lines;
  for (std::string line; lines.size() < kLooksAtLines && std::getline(in, line);) {
    if (line.ends_with('\r')) line.pop_back();
    if (line.size() > kLongestLine) return {};
    lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> cells_of(const std::string& line, char separator) {
  std::vector<std::string> cells(1);
  for (const char letter : line) {
    if (letter == separator) {
      cells.emplace_back();
    } else if (letter != '"' && letter != ' ') {
      cells.back() += letter;
    }
  }
  return cells;
}

/// As far as its letters tell.
bool is_number(const std::string& cell) {
  const bool has_digit = std::any_of(
      cell.begin(), cell.end(), [](unsigned char letter) { return std::isdigit(letter) != 0; });
  return has_digit && cell.find_first_not_of("0123456789+-.,eE") == cell.npos;
}

bool are_numbers(const std::vector<std::string>& cells) {
  return std::all_of(cells.begin(), cells.end(), is_number);
}

bool are_names(const std::vector<std::string>& cells) {
  return cells.size() > 1 && std::all_of(cells.begin(), cells.end(), [](const auto& cell) {
           return !cell.empty() && !is_number(cell);
         });
}

bool begins_at(const std::vector<std::string>& lines, std::size_t at, char separator) {
  const std::vector<std::string> names = cells_of(lines[at], separator);
  if (!are_names(names)) return false;
  for (std::size_t row = at + 1; row < at + 3; ++row) {
    const std::vector<std::string> cells = cells_of(lines[row], separator);
    if (cells.size() != names.size() || !are_numbers(cells)) return false;
  }
  return true;
}

}  // namespace

std::optional<TableBegin> find_table_begin(const std::string& file) {
  const std::vector<std::string> lines = first_lines(file);
  for (std::size_t at = 1; at + 2 < lines.size(); ++at) {
    for (const char separator : {',', ';', '\t'}) {
      if (!begins_at(lines, at, separator)) continue;
      const std::string& names = lines[at];
      const bool is_long = names.size() > kShownLetters;
      return TableBegin{at + 1, is_long ? names.substr(0, kShownLetters) + "..." : names};
    }
  }
  return std::nullopt;
}

}  // namespace torquewright::io
