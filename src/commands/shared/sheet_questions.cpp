// SPDX-License-Identifier: Apache-2.0
#include "src/commands/shared/sheet_questions.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <string_view>

#include "io/faults/refusal.hpp"

namespace torquewright::cli {
namespace {

constexpr const char* kBlanks = " \t\r";

std::string trimmed(const std::string& line) {
  const std::size_t first = line.find_first_not_of(kBlanks);
  if (first == std::string::npos) return "";
  return line.substr(first, line.find_last_not_of(kBlanks) - first + 1);
}

void say(const std::string& text) { std::fputs(text.c_str(), stderr); }

std::string number_of(std::size_t question) {
  return fmt::format("{} of {}", question + 1, kSheetQuestions.size());
}

/// What sheets print, and people type, where there is no number.
std::string known_part(std::string answer) {
  for (const std::string_view none : {"-", "--", "\u2013", "\u2014", "n/a", "N/A", "n.a.", "none",
                                      "?", "unknown", "not stated"}) {
    if (answer == none) return "";
  }
  return answer;
}

std::string next_line(std::size_t question, bool is_asked) {
  std::string line;
  if (std::getline(std::cin, line)) return known_part(trimmed(line));
  if (is_asked) say("\n");
  io::refuse("standard input",
             fmt::format("ends before answer {} ({}); an empty line says that a number is not "
                         "known. Nothing is written",
                         number_of(question), kSheetQuestions[question].name));
}

std::string asked(std::size_t question, const Objection& objection) {
  const SheetQuestion& about = kSheetQuestions[question];
  say(fmt::format("\n{}. {}\n", number_of(question), about.meaning));
  while (true) {
    say(fmt::format("{} [{}]: ", about.name, about.example));
    std::string answer = next_line(question, true);
    const auto wrong = answer.empty() ? std::nullopt : objection(about, answer);
    if (!wrong) return answer;
    say(fmt::format("  {}\n", *wrong));
  }
}

std::string read(std::size_t question, const Objection& objection) {
  std::string answer = next_line(question, false);
  if (answer.empty()) return answer;
  if (const auto wrong = objection(kSheetQuestions[question], answer)) {
    io::refuse(
        fmt::format("standard input, line {} ({})", question + 1, kSheetQuestions[question].name),
        *wrong);
  }
  return answer;
}

/// A line too many says that the answers are not those of the questions.
void require_end() {
  for (std::string line; std::getline(std::cin, line);) {
    if (trimmed(line).empty()) continue;
    io::refuse("standard input", fmt::format("goes on after {} answers with \"{}\"",
                                             kSheetQuestions.size(), trimmed(line)));
  }
}

}  // namespace

SheetAnswers ask_sheet(const Objection& objection) {
  const bool is_asked = isatty(STDIN_FILENO) == 1;
  SheetAnswers answers;
  if (is_asked) {
    say("Numbers as printed, with units; > or < where a bound stands; Enter alone: none.\n");
  }
  for (std::size_t i = 0; i < answers.size(); ++i) {
    answers[i] = is_asked ? asked(i, objection) : read(i, objection);
  }
  if (is_asked) {
    say("\n");
  } else {
    require_end();
  }
  return answers;
}

}  // namespace torquewright::cli
