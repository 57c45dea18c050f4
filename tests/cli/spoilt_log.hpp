// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace torquewright::cli_test {

/// A CSV log as cells of text, to be spoilt by hand.
class SpoiltLog {
 public:
  explicit SpoiltLog(const std::string& text) {
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);
    header = cells_of(line);
    while (std::getline(lines, line)) rows.push_back(cells_of(line));
  }

  std::string& at(std::size_t row, const std::string& column) {
    return rows.at(row).at(index_of(column));
  }
  double number(std::size_t row, const std::string& column) { return std::stod(at(row, column)); }

  /// Every number of a column by a law of itself.
  void each(const std::string& column, const std::function<double(double)>& law) {
    for (std::size_t row = 0; row < rows.size(); ++row) {
      at(row, column) = fmt::format("{:.9g}", law(number(row, column)));
    }
  }

  void drop(const std::string& column) {
    const auto index = static_cast<std::ptrdiff_t>(index_of(column));
    header.erase(header.begin() + index);
    for (auto& row : rows) row.erase(row.begin() + index);
  }
  void erase_rows(std::size_t first, std::size_t count) {
    const auto begin = rows.begin() + static_cast<std::ptrdiff_t>(first);
    rows.erase(begin, begin + static_cast<std::ptrdiff_t>(count));
  }

  std::string text() const {
    std::string text = line_of(header);
    for (const auto& row : rows) text += line_of(row);
    return text;
  }

  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;

 private:
  std::size_t index_of(const std::string& column) const {
    const auto found = std::find(header.begin(), header.end(), column);
    if (found == header.end()) throw std::logic_error("no column " + column);
    return static_cast<std::size_t>(found - header.begin());
  }
  static std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream text(line);
    std::string cell;
    while (std::getline(text, cell, ',')) cells.push_back(cell);
    return cells;
  }
  static std::string line_of(const std::vector<std::string>& cells) {
    std::string line;
    for (const std::string& cell : cells) line += (line.empty() ? "" : ",") + cell;
    return line + "\n";
  }
};

}  // namespace torquewright::cli_test
