// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/program/table_mutation.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "tests/fuzz/program/chance.hpp"

namespace torquewright::fuzz {
namespace {

using Row = std::vector<std::string>;

const std::vector<std::string> kCells{
    "nan",  "NaN",   "inf",  "-inf", "",    " ",     "1e308",   "-1e308", "1e-310",  "1e400",
    "-0",   "0",     "1e9",  "-1e9", "abc", "\"1\"", "\"a,b\"", "\"",     "1;2",     "1,2",
    "\xFF", "1.7e9", "1e-9", "+5",   "0x1", "1 2",   "true",    "=1+1",   "\xC2\xB0"};

struct Table {
  std::vector<std::string> comments;  ///< Before the header.
  std::vector<Row> rows;              ///< The first is the header.
};

Row cells_of(const std::string& line) {
  Row cells{""};
  for (const char c : line) {
    if (c == ',') {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

Table read_table(const std::string& text) {
  Table table;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    if (table.rows.empty() && line.starts_with('#')) {
      table.comments.push_back(line);
    } else {
      table.rows.push_back(cells_of(line));
    }
    at = end + 1;
  }
  return table;
}

std::string text_of(const Table& table, const std::string& separator, const std::string& end) {
  std::string text;
  for (const std::string& comment : table.comments) text += comment + end;
  for (const Row& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) text += (i > 0 ? separator : "") + row[i];
    text += end;
  }
  return text;
}

Row& any_row(Table& table, Random& random) {
  return table.rows[one_below(table.rows.size(), random)];
}

std::size_t columns(const Table& table) { return table.rows.front().size(); }

/// A function of each number in one column.
template <typename Function>
void change_column(Table& table, std::size_t column, Function function) {
  for (std::size_t i = 1; i < table.rows.size(); ++i) {
    if (column >= table.rows[i].size()) continue;
    std::string& cell = table.rows[i][column];
    char number[40];
    std::snprintf(number, sizeof number, "%.17g", function(std::strtod(cell.c_str(), nullptr), i));
    cell = number;
  }
}

void change_numbers(Table& table, Random& random) {
  const std::vector<double> factors{0.0, -1.0, 1e-3, 1e3, 1e-300, 1e300, 1e-12, 57.3};
  const std::vector<double> shifts{1.7e9, -5.0, 1e-9, 1e308, 1.0};
  const std::size_t column = one_below(columns(table), random);
  const double factor = once_in(2, random) ? 1.0 : one_of(factors, random);
  const double shift = once_in(2, random) ? 0.0 : one_of(shifts, random);
  const std::size_t step = once_in(4, random) ? 1 + one_below(table.rows.size(), random) : 0;
  change_column(table, column, [&](double value, std::size_t row) {
    return value * factor + shift + (step > 0 && row > step ? 1.0 : 0.0);
  });
}

void change_rows(Table& table, Random& random) {
  const auto at = [&] { return static_cast<long>(one_below(table.rows.size() + 1, random)); };
  const auto one = table.rows.begin() + at(), other = table.rows.begin() + at();
  const auto first = std::min(one, other), last = std::max(one, other);
  switch (one_below(4, random)) {
    case 0:
      table.rows.erase(first, last);
      break;
    case 1:
      std::reverse(first, last);
      break;
    case 2:
      table.rows.resize(std::min<std::size_t>(table.rows.size(), 1 + one_below(4, random)));
      break;
    default: {
      const std::vector<Row> piece(first, std::min(last, first + 50));
      table.rows.insert(table.rows.begin() + at(), piece.begin(), piece.end());
    }
  }
}

void change_columns(Table& table, Random& random) {
  const std::size_t column = one_below(columns(table), random);
  const std::size_t other = one_below(columns(table), random);
  const bool drops = once_in(2, random);
  const bool in_header_alone = once_in(4, random);
  for (Row& row : table.rows) {
    if (column >= row.size() || other >= row.size()) continue;
    if (drops) {
      row.erase(row.begin() + static_cast<long>(column));
    } else {
      row.push_back(row[other]);
    }
    if (in_header_alone) break;
  }
}

void change_cell(Table& table, Random& random) {
  Row& row = once_in(5, random) ? table.rows.front() : any_row(table, random);
  if (!row.empty()) row[one_below(row.size(), random)] = one_of(kCells, random);
}

}  // namespace

std::string changed_table(const std::string& text, Random& random) {
  if (once_in(6, random)) return mutated({text}, random);
  Table table = read_table(text);
  const std::vector<std::string> separators{",", ",", ",", ",", ",", ";", "\t"};
  const std::vector<std::string> ends{"\n", "\n", "\n", "\n", "\r\n", "\r"};
  for (std::size_t count = 1 + one_below(3, random); count > 0 && !table.rows.empty(); --count) {
    if (table.rows.front().empty()) break;
    switch (one_below(6, random)) {
      case 0:
        change_rows(table, random);
        break;
      case 1:
        change_columns(table, random);
        break;
      case 2:
      case 3:
        change_cell(table, random);
        break;
      default:
        change_numbers(table, random);
    }
  }
  return text_of(table, one_of(separators, random), one_of(ends, random));
}

}  // namespace torquewright::fuzz
