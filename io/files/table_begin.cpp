// SPDX-License-Identifier: Apache-2.0
#include "io/files/table_begin.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <vector>

#include "io/text/cell_number.hpp"

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

bool is_number(const std::string& cell) {
  return number_of(cell).has_value() || !with_point(cell).empty();
}

bool are_numbers(const std::vector<std::string>& cells) {
  return std::all_of(cells.begin(), cells.end(), is_number);
}

bool are_names(const std::vector<std::string>& cells) {
  return cells.size() > 1 && std::all_of(cells.begin(), cells.end(), [](const auto& cell) {
           return !cell.empty() && !is_number(cell);
         });
}

bool is_row_of(const std::vector<std::string>& names, std::vector<std::string> cells) {
  const bool has_comments = names.back() == "Comment";
  if (has_comments && cells.size() == names.size()) cells.pop_back();
  return cells.size() + (has_comments ? 1 : 0) == names.size() && are_numbers(cells);
}

/// Where names begin a table: a line of them, and the separator of their cells.
struct NamesLine {
  std::size_t at = 0;  ///< Of the lines, from 0.
  char separator = ',';
};

bool begins_at(const std::vector<std::string>& lines, const NamesLine& line) {
  const std::vector<std::string> names = cells_of(lines[line.at], line.separator);
  if (!are_names(names)) return false;
  std::size_t row = line.at + 1;
  const std::vector<std::string> behind = cells_of(lines[row], line.separator);
  if (are_names(behind) && behind.size() == names.size()) ++row;  // of units
  const auto are_rows = [&](std::size_t first) {
    return first + 1 < lines.size() && is_row_of(names, cells_of(lines[first], line.separator)) &&
           is_row_of(names, cells_of(lines[first + 1], line.separator));
  };
  return are_rows(row);
}

std::optional<NamesLine> names_line(const std::vector<std::string>& lines) {
  for (std::size_t at = 1; at + 2 < lines.size(); ++at) {
    for (const char separator : {',', ';', '\t'}) {
      if (begins_at(lines, {at, separator})) return NamesLine{at, separator};
    }
  }
  return std::nullopt;
}

/// What a table may have before its names: comments, and a spreadsheet's word about separators.
bool is_comment(const std::string& line) {
  return line.starts_with('#') || line.starts_with("sep=") ||
         line.find_first_not_of(" \t") == line.npos;
}

/// Whether a line is neither one of the table that begins behind it nor, for want of numbers, one
/// of another table.
bool is_no_row(const std::string& line, std::size_t names, char separator) {
  const std::vector<std::string> cells = cells_of(line, separator);
  return cells.size() != names && std::count_if(cells.begin(), cells.end(), is_number) < 2;
}

/// Behind LabVIEW's last mark; 0 where none stands.
std::size_t end_of_header(const std::vector<std::string>& lines) {
  std::size_t end = 0;
  for (std::size_t at = 0; at < lines.size(); ++at) {
    if (lines[at].starts_with("***End_of_Header***")) end = at + 1;
  }
  return end;
}

}  // namespace

std::optional<TableBegin> find_table_begin(const std::string& file) {
  const std::vector<std::string> lines = first_lines(file);
  const std::optional<NamesLine> found = names_line(lines);
  if (!found) return std::nullopt;
  const std::string& names = lines[found->at];
  const bool is_long = names.size() > kShownLetters;
  return TableBegin{found->at + 1, is_long ? names.substr(0, kShownLetters) + "..." : names};
}

std::size_t lines_before_table(const std::string& file) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(file, unknown)) return 0;  // a pipe is read once
  const std::vector<std::string> lines = first_lines(file);
  const std::optional<NamesLine> found = names_line(lines);
  if (!found) return 0;
  const std::size_t names = cells_of(lines[found->at], found->separator).size();
  const std::size_t header_end = end_of_header(lines);
  bool has_others = false;  // than comments
  for (std::size_t at = 0; at < found->at; ++at) {
    if (is_comment(lines[at])) continue;
    has_others = true;
    if (at >= header_end && !is_no_row(lines[at], names, found->separator)) return 0;
  }
  return has_others ? found->at : 0;
}

}  // namespace torquewright::io
