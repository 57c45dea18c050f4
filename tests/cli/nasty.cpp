// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/nasty.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "tests/cli/no_number.hpp"
#include "tests/cli/well_formed.hpp"

namespace torquewright::cli_test {
namespace {

using Words = std::vector<std::string>;

/// Where the cell of that number starts in a row, and the next one.
std::pair<std::size_t, std::size_t> cell_of(const std::string& line, std::size_t index) {
  std::size_t start = 0;
  for (std::size_t i = 0; i < index; ++i) start = line.find(',', start) + 1;
  return {start, std::min(line.find(',', start), line.size())};
}

/// A table in lines: those before the header (remarks), the header, the rows.
struct Table {
  std::string remarks, header;
  Words rows;

  explicit Table(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      if (header.empty() && line.starts_with('#')) {
        remarks += line + "\n";
      } else if (header.empty()) {
        header = line;
      } else {
        rows.push_back(line);
      }
    }
  }

  std::string head() const { return remarks + header + "\n"; }

  std::string text() const {
    std::string text = head();
    for (const std::string& row : rows) text += row + "\n";
    return text;
  }

  std::size_t column(const std::string& name) const {
    const std::size_t place = ("," + header + ",").find("," + name + ",");
    if (place == std::string::npos) return std::string::npos;
    return static_cast<std::size_t>(
        std::count(header.begin(), header.begin() + static_cast<long>(place), ','));
  }

  std::size_t time_column() const {
    return std::min(column("time_s"), column("t_s"));  // one of them is missing
  }

  /// The last one of numbers.
  std::size_t last_column() const {
    const auto last = static_cast<std::size_t>(std::count(header.begin(), header.end(), ','));
    return column("run") == last ? last - 1 : last;
  }

  void write(std::size_t row, std::size_t cell, const std::string& value) {
    std::string& line = rows.at(row);
    const auto [start, end] = cell_of(line, cell);
    line = line.substr(0, start) + value + line.substr(end);
  }
};

std::string with_times(const std::string& text, const std::function<double(double)>& change) {
  Table table(text);
  const std::size_t time = table.time_column();
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const auto [start, end] = cell_of(table.rows[row], time);
    std::array<char, 40> number{};
    std::snprintf(number.data(), number.size(), "%.17g",
                  change(std::stod(table.rows[row].substr(start, end - start))));
    table.write(row, time, number.data());
  }
  return table.text();
}

/// With these in two rows, the second and the third, of the last column.
std::string with_cells(const std::string& text, const std::string& second,
                       const std::string& third) {
  Table table(text);
  table.write(1, table.last_column(), second);
  table.write(2, table.last_column(), third);
  return table.text();
}

/// 2000 keys that nobody knows.
std::string with_a_thousand_faults(const std::string& text) {
  std::string keys;
  if (!text.starts_with('{')) return text;  // XML
  for (int i = 0; i < 2000; ++i) keys += "\"x" + std::to_string(i) + "\": 1, ";
  return "{" + keys + text.substr(text.find('{') + 1);
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
      {"one row", [](const auto& text) { return Table(text).head() + Table(text).rows[0] + "\n"; }},
      {"header alone", [](const auto& text) { return Table(text).head(); }, true},
      {"nothing", [](const auto&) { return std::string(); }, true},
      {"nan in a cell", [](const auto& text) { return with_cells(text, "nan", "0"); }, true},
      {"infinity in a cell", [](const auto& text) { return with_cells(text, "0", "-inf"); }, true},
      {"subnormal cell", [](const auto& text) { return with_cells(text, "1e-310", "-1e-310"); }},
      {"greatest cell", [](const auto& text) { return with_cells(text, "1e308", "-1e308"); }},
      {"carriage returns",
       [](std::string text) {
         text = text.substr(Table(text).remarks.size());
         for (char& c : text) c = c == '\n' ? '\r' : c;
         return text;
       },
       true},
      {"Latin-1",
       [](const auto& text) {
         return "T [\xB0"
                "C]," +
                text.substr(Table(text).remarks.size());
       },
       true},
      {"a spreadsheet's separator", [](const auto& text) { return "sep=|\n" + text; }, true},
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
      {"a thousand faults", with_a_thousand_faults},
      {"a thousand faults and a resistance below zero",
       [](std::string text) {
         const std::string key = "\"resistance_ohm\": ";
         const std::size_t at = text.find(key);
         if (at != std::string::npos) text.insert(at + key.size(), "-");
         return with_a_thousand_faults(text);
       }},
      {"a newline in the name", named("a\\nb")},
      {"U+FFFE in the name", named("a\\uFFFE")},
      {"no UTF-8", [](const auto& text) { return text + "\xFF"; }},
      {"nothing", [](const auto&) { return std::string(); }},
      {"deep", [](const auto&) { return std::string(100000, '['); }},
      {"a number that overflows", [](const auto&) { return std::string("{\"kind\": 1e999}"); }},
  };
}

std::vector<NastyNumber> nasty_numbers() {
  return {{"nan", true},   {"inf", true}, {"-inf", true}, {"1e-310"}, {"1e308"},
          {"1e400", true}, {"-0"},        {"", true},     {" ", true}};
}

namespace {

/// Without the words of the command that it repeats, and what stands within quotes.
std::string own_words(std::string text, const Words& command) {
  for (const std::string& word : command) {
    const std::size_t at = word.size() < 3 ? std::string::npos : text.find(word);
    if (at != std::string::npos) text.erase(at, word.size());
  }
  std::string rest;
  bool is_quoted = false;
  for (const char character : text) {
    if (character == '"') is_quoted = !is_quoted;
    if (!is_quoted) rest += character;
  }
  return rest;
}

/// One document, or a line each, as in a journal.
bool is_json(const std::string& text) {
  if (nlohmann::json::accept(text)) return true;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!nlohmann::json::accept(line)) return false;
  }
  return true;
}

/// What is wrong with a text that the program made; empty: nothing.
std::string fault_of_answer(const std::string& text) {
  if (text.starts_with("\x89PNG")) return "";
  if (test::says_no_number(text)) return "says nan or inf";
  if (text.starts_with('{') && !is_json(text)) return "is no JSON";
  return text.starts_with('<') ? fault_in(text) : fault_of_characters_in(text);
}

}  // namespace

Outcome expect_civil(const Workplace& place, const Words& command, const std::string& what,
                     std::size_t files) {
  const auto before = place.files();
  const Outcome outcome = place.run(command);
  EXPECT_TRUE(outcome.exit_code >= 0 && outcome.exit_code <= 3)
      << what << ": " << outcome.exit_code << " " << outcome.err;
  EXPECT_TRUE(outcome.exit_code != 2 || !outcome.err.empty()) << what;
  EXPECT_EQ(fault_of_answer(outcome.out), "") << what << ": " << outcome.out;
  EXPECT_FALSE(test::says_no_number(own_words(outcome.err, command)))
      << what << ": " << outcome.err;
  EXPECT_EQ(fault_of_characters_in(outcome.err), "") << what << ": " << outcome.err;
  EXPECT_LE(outcome.err.size(), 5'000'000u) << what;
  const auto after = place.files();
  EXPECT_EQ(after.size(), files) << what << " leaves a file behind";
  for (const auto& [name, text] : after) {
    const auto old = before.find(name);
    if (old != before.end() && old->second == text) continue;
    EXPECT_EQ(fault_of_answer(text), "") << what << ": " << name << " of " << command[1];
  }
  return outcome;
}

void expect_judged(const Workplace& place, const Words& command, const std::string& what,
                   std::size_t files, bool is_refused) {
  const Outcome outcome = expect_civil(place, command, what, files);
  EXPECT_TRUE(outcome.exit_code == 2 || !is_refused)
      << what << ": " << command[0] << " " << command[1] << ": " << outcome.out;
}

void expect_refused(const Workplace& place, const Words& command, const std::string& what,
                    std::size_t files) {
  expect_judged(place, command, what, files, true);
}

void expect_sound(const Workplace& place, const Words& command, std::size_t files) {
  const Outcome outcome = expect_civil(place, command, "unspoilt", files);
  std::string words;
  for (const std::string& word : command) words += word + " ";
  EXPECT_NE(outcome.exit_code, 2) << words << ": " << outcome.err;
}

}  // namespace torquewright::cli_test
