// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/nasty.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <sstream>
#include <utility>

#include "tests/cli/no_number.hpp"

namespace torquewright::cli_test {
namespace {

/// Where the cell of that number starts in a row, and the next one.
std::pair<std::size_t, std::size_t> cell_of(const std::string& line, std::size_t index) {
  std::size_t start = 0;
  for (std::size_t i = 0; i < index; ++i) start = line.find(',', start) + 1;
  return {start, std::min(line.find(',', start), line.size())};
}

/// A table with its column time_s through a function.
std::string with_times(const std::string& table, const std::function<double(double)>& change) {
  std::istringstream lines(table);
  std::string text;
  std::optional<std::size_t> column;
  for (std::string line; std::getline(lines, line); text += line + "\n") {
    if (line.starts_with('#')) continue;
    if (!column) {
      const auto end = line.begin() + static_cast<long>(line.find("time_s"));
      column = static_cast<std::size_t>(std::count(line.begin(), end, ','));
      continue;
    }
    const auto [start, end] = cell_of(line, *column);
    std::array<char, 40> number{};
    std::snprintf(number.data(), number.size(), "%.17g",
                  change(std::stod(line.substr(start, end - start))));
    line = line.substr(0, start) + number.data() + line.substr(end);
  }
  return text;
}

std::string first_lines(const std::string& text, int count) {
  std::size_t at = 0;
  for (int i = 0; i < count && at != std::string::npos; ++i) at = text.find('\n', at) + 1;
  return text.substr(0, at);
}

}  // namespace

std::vector<Nasty> nasty_tables() {
  return {
      {"epoch time",
       [](const auto& text) { return with_times(text, [](double t) { return t + 1.7e9; }); }},
      {"times of 1e-300 s",
       [](const auto& text) { return with_times(text, [](double t) { return t * 1e-300; }); }},
      {"times of 1e300 s",
       [](const auto& text) { return with_times(text, [](double t) { return t * 1e300; }); }},
      {"one row",
       [](const auto& text) { return first_lines(text, text.starts_with('#') ? 5 : 2); }},
      {"header alone", [](const auto& text) { return first_lines(text, 1); }},
      {"nothing", [](const auto&) { return std::string(); }},
      {"nan in a cell",
       [](const auto& text) { return first_lines(text, 1) + "0,nan,0,0\n1,0,0,0\n"; }},
      {"subnormal cell",
       [](const auto& text) { return first_lines(text, 1) + "0,1e-310,0,0\n1,0,0,0\n"; }},
      {"greatest cell",
       [](const auto& text) { return first_lines(text, 1) + "0,1e308,0,-1e308\n1,0,0,1e308\n"; }},
      {"carriage returns",
       [](std::string text) {
         for (char& c : text) c = c == '\n' ? '\r' : c;
         return text;
       }},
      {"Latin-1",
       [](const auto& text) {
         return "T [\xB0"
                "C]," +
                text;
       }},
      {"a spreadsheet's separator", [](const auto& text) { return "sep=,\n" + text; }},
      {"zero bytes", [](const auto& text) { return text + std::string(3, '\0'); }},
  };
}

std::vector<Nasty> nasty_documents() {
  const auto named = [](const std::string& name) {
    return [name](const std::string& text) {
      const std::size_t at = text.find("\"name\": \"");
      return at == std::string::npos ? text : text.substr(0, at + 9) + name + text.substr(at + 9);
    };
  };
  return {
      {"a thousand faults",
       [](const auto& text) {
         std::string keys;
         for (int i = 0; i < 2000; ++i) keys += "\"x" + std::to_string(i) + "\": 1, ";
         return "{" + keys + "\"kind\": \"rig\", " + text.substr(text.find('{') + 1);
       }},
      {"a newline in the name", named("a\\nb")},
      {"U+FFFE in the name", named("a\\uFFFE")},
      {"no UTF-8", [](const auto& text) { return text + "\xFF"; }},
      {"nothing", [](const auto&) { return std::string(); }},
      {"deep", [](const auto&) { return std::string(100000, '['); }},
      {"a number that overflows", [](const auto&) { return std::string("{\"kind\": 1e999}"); }},
  };
}

std::vector<std::string> nasty_numbers() {
  return {"nan", "inf", "-inf", "1e-310", "1e308", "1e400", "-0", "", " "};
}

void expect_civil(const Workplace& place, const std::vector<std::string>& command,
                  const std::string& what, std::size_t files) {
  const Outcome outcome = place.run(command);
  EXPECT_TRUE(outcome.exit_code >= 0 && outcome.exit_code <= 3)
      << what << ": " << outcome.exit_code << " " << outcome.err;
  EXPECT_TRUE(outcome.exit_code != 2 || !outcome.err.empty()) << what;
  EXPECT_FALSE(test::says_no_number(outcome.out)) << what << ": " << outcome.out;
  EXPECT_LE(outcome.err.size(), 5'000'000u) << what;
  EXPECT_EQ(place.files().size(), files) << what << " leaves a file behind";
}

}  // namespace torquewright::cli_test
