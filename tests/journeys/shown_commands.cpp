// SPDX-License-Identifier: Apache-2.0
#include "tests/journeys/shown_commands.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <regex>
#include <sstream>

namespace torquewright::journeys {
namespace {

using Lines = std::vector<std::string>;

constexpr double kSmall = 5e-3;
const std::string kIndent = "    ";
const std::string kAny = "...";

Lines lines_of(const std::string& text) {
  std::istringstream stream(text);
  Lines lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

Lines words_of(const std::string& text) {
  std::istringstream stream(text);
  Lines words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

bool is_blank(const std::string& line) { return line.find_first_not_of(' ') == std::string::npos; }

/// A line cut into what is a number and what is not.
struct Pieces {
  Lines words;
  std::vector<double> numbers;
};

Pieces pieces_of(const std::string& line) {
  static const std::regex number(R"([-+]?\d+(\.\d+)?(e[-+]?\d+)?)");
  Pieces pieces;
  std::string joined;
  for (const std::string& word : words_of(line)) joined += (joined.empty() ? "" : " ") + word;
  std::size_t end = 0;
  for (std::sregex_iterator it(joined.begin(), joined.end(), number), none; it != none; ++it) {
    pieces.words.push_back(joined.substr(end, static_cast<std::size_t>(it->position()) - end));
    pieces.numbers.push_back(std::strtod(it->str().c_str(), nullptr));
    end = static_cast<std::size_t>(it->position() + it->length());
  }
  pieces.words.push_back(joined.substr(end));
  return pieces;
}

bool is_near(double a, double b, double share) {
  return std::abs(a - b) <= std::max(kSmall, share * std::max(std::abs(a), std::abs(b)));
}

bool is_printed_as(std::string shown, const std::string& line, double share) {
  const bool goes_on = shown.ends_with(kAny);
  if (goes_on) shown.resize(shown.size() - kAny.size());
  Pieces wanted = pieces_of(shown), got = pieces_of(line);
  if (goes_on) {
    if (got.numbers.size() < wanted.numbers.size()) return false;
    got.numbers.resize(wanted.numbers.size());
    got.words.resize(wanted.words.size());
    got.words.back().resize(std::min(got.words.back().size(), wanted.words.back().size()));
  }
  return wanted.words == got.words &&
         std::equal(wanted.numbers.begin(), wanted.numbers.end(), got.numbers.begin(),
                    got.numbers.end(), [&](double a, double b) { return is_near(a, b, share); });
}

}  // namespace

std::vector<ShownCommand> commands_of(const std::string& page) {
  std::vector<ShownCommand> commands;
  bool is_in_block = false;
  for (const std::string& line : lines_of(page)) {
    if (is_blank(line)) continue;
    if (!line.starts_with(kIndent)) {
      is_in_block = false;
      continue;
    }
    const std::string text = line.substr(kIndent.size());
    const Lines words = words_of(text);
    if (words.front() == "torquewright") {
      commands.push_back({{words.begin() + 1, words.end()}, {}});
      is_in_block = true;
    } else if (is_in_block) {
      commands.back().printed.push_back(text);
    }
  }
  return commands;
}

std::string first_unprinted(const std::vector<std::string>& shown, const std::string& output,
                            double share) {
  Lines lines = lines_of(output);
  lines.erase(std::remove_if(lines.begin(), lines.end(), is_blank), lines.end());
  auto at = lines.begin();
  bool may_skip = false;
  for (const std::string& line : shown) {
    if (words_of(line) == Lines{kAny}) {
      may_skip = true;
      continue;
    }
    const auto is_it = [&](const std::string& one) { return is_printed_as(line, one, share); };
    const auto found = may_skip ? std::find_if(at, lines.end(), is_it) : at;
    if (found == lines.end() || !is_it(*found)) return line;
    at = found + 1;
    may_skip = false;
  }
  return "";
}

}  // namespace torquewright::journeys
