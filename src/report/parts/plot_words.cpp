// SPDX-License-Identifier: Apache-2.0
#include "src/report/parts/plot_words.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <string>

#include "src/report/parts/svg.hpp"

namespace torquewright::report {
namespace {

constexpr std::string_view kPlot = "plot ";
constexpr std::string_view kNumbered = "<title>gnuplot_plot_";
constexpr std::string_view kEnd = "</title>";

/// The word that ends the block of data which a line begins; empty: it begins none.
std::string_view end_of_data(std::string_view line) {
  constexpr std::string_view kUntil = " << ";
  const std::size_t at = line.starts_with('$') ? line.find(kUntil) : std::string_view::npos;
  return at == std::string_view::npos ? std::string_view() : line.substr(at + kUntil.size());
}

/// The lines of commands, each with those that continue it, without blocks of data.
std::vector<std::string> commands_of(std::string_view script) {
  std::vector<std::string> commands;
  std::string_view data_end;
  bool goes_on = false;
  while (!script.empty()) {
    const std::size_t end = std::min(script.find('\n'), script.size());
    std::string_view line = script.substr(0, end);
    script.remove_prefix(std::min(end + 1, script.size()));
    if (!data_end.empty()) {
      if (line == data_end) data_end = {};
      continue;
    }
    data_end = end_of_data(line);
    if (!data_end.empty()) continue;
    const bool continues = line.ends_with('\\');
    if (continues) line.remove_suffix(1);
    if (goes_on) {
      commands.back() += line;
    } else {
      commands.emplace_back(line);
    }
    goes_on = continues;
  }
  return commands;
}

/// What stands in the quotes that begin at `at`; `at` goes behind them.
std::string quoted_at(std::string_view text, std::size_t& at) {
  const std::size_t end = std::min(text.find('\'', at + 1), text.size());
  const std::string_view inside = text.substr(at + 1, end - at - 1);
  at = std::min(end + 1, text.size());
  return std::string(inside);
}

bool ends_with_word(std::string_view text, std::string_view word) {
  text = text.substr(0, text.find_last_not_of(' ') + 1);
  if (!text.ends_with(word)) return false;
  const std::size_t before = text.size() - word.size();
  return before == 0 || text[before - 1] == ' ';
}

bool names_a_plot(std::string_view before) {
  return ends_with_word(before, "title") || ends_with_word(before, "notitle");
}

std::vector<std::string> names_of(std::string_view command) {
  std::vector<std::string> names{""};
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t at = 0; at < command.size();) {
    const char character = command[at];
    if (character == '\'') {
      const std::string_view before = command.substr(begin, at - begin);
      std::string inside = quoted_at(command, at);
      if (names_a_plot(before)) names.back() = std::move(inside);
      continue;
    }
    if (character == '(') ++depth;
    if (character == ')') --depth;
    if (character == ',' && depth == 0) {
      names.emplace_back();
      begin = at + 1;
    }
    ++at;
  }
  return names;
}

/// That of all panels, else the first one's.
std::string title_of(const std::vector<std::string>& commands) {
  std::string title;
  for (const std::string& command : commands) {
    const bool is_whole = command.starts_with("set multiplot");
    if (!is_whole && !command.starts_with("set title ")) continue;
    const std::size_t word = command.find("title '");
    if (word == std::string::npos) continue;
    std::size_t quote = word + std::string_view("title ").size();
    if (is_whole) return quoted_at(command, quote);
    if (title.empty()) title = quoted_at(command, quote);
  }
  return title;
}

std::string title_element(const std::string& words) {
  return words.empty() ? "" : "<title>" + escaped(words) + std::string(kEnd);
}

/// Walks through the names as gnuplot numbers its plots: from 1 in each panel, whose letter
/// follows.
class Numbered {
 public:
  explicit Numbered(std::vector<std::vector<std::string>> names) : names_(std::move(names)) {}

  std::string name_of(std::string_view number_and_letter) {
    std::size_t number = 0;
    const char* end = number_and_letter.data() + number_and_letter.size();
    const char* letter = std::from_chars(number_and_letter.data(), end, number).ptr;
    const std::string panel(letter, end);
    if (is_begun_ && panel != panel_) ++command_;
    is_begun_ = true;
    panel_ = panel;
    if (command_ >= names_.size() || number == 0 || number > names_[command_].size()) return "";
    return names_[command_][number - 1];
  }

 private:
  std::vector<std::vector<std::string>> names_;
  std::size_t command_ = 0;
  std::string panel_;
  bool is_begun_ = false;
};

}  // namespace

std::vector<std::vector<std::string>> plot_names(std::string_view script) {
  std::vector<std::vector<std::string>> names;
  for (const std::string& command : commands_of(script)) {
    if (command.starts_with(kPlot)) names.push_back(names_of(command));
  }
  return names;
}

std::string with_plot_words(std::string_view svg, std::string_view script) {
  constexpr std::string_view kOwnName = "<title>Gnuplot</title>";
  std::string text;
  if (const std::size_t own = svg.find(kOwnName); own != std::string_view::npos) {
    text = std::string(svg.substr(0, own)) + title_element(title_of(commands_of(script)));
    svg.remove_prefix(own + kOwnName.size());
  }
  Numbered numbered(plot_names(script));
  for (std::size_t at = svg.find(kNumbered); at != std::string_view::npos;
       at = svg.find(kNumbered)) {
    const std::size_t from = at + kNumbered.size();
    const std::size_t end = std::min(svg.find(kEnd, from), svg.size());
    text += svg.substr(0, at);
    text += title_element(numbered.name_of(svg.substr(from, end - from)));
    svg.remove_prefix(std::min(end + kEnd.size(), svg.size()));
  }
  return text += svg;
}

}  // namespace torquewright::report
