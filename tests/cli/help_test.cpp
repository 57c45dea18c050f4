// SPDX-License-Identifier: Apache-2.0
// The help of every command holds one example, and the example works where the README says that
// commands are run: in the repository's root.
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using Words = std::vector<std::string>;

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

Words words_of(const std::string& line) {
  std::istringstream stream(line);
  Words words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::string help_of(Words command) {
  command.push_back("--help");
  const Outcome outcome = run(command);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  return outcome.out;
}

/// The words that stand first in the lines below "Commands:".
Words subcommands(const std::string& help) {
  Words names;
  bool is_listed = false;
  for (const std::string& line : lines_of(help)) {
    const Words words = words_of(line);
    if (is_listed && words.empty()) break;
    if (is_listed && !line.starts_with("   ")) names.push_back(words.front());
    if (line == "Commands:") is_listed = true;
  }
  return names;
}

/// The app, its groups and their commands, as the help lists them.
std::vector<Words> all_commands(const Words& from = {}) {
  std::vector<Words> commands{from};
  for (const std::string& name : subcommands(help_of(from))) {
    Words command = from;
    command.push_back(name);
    for (const Words& each : all_commands(command)) commands.push_back(each);
  }
  return commands;
}

/// The lines below "Example:".
std::vector<Words> examples(const std::string& help) {
  std::vector<Words> examples;
  bool is_listed = false;
  for (const std::string& line : lines_of(help)) {
    if (is_listed && !words_of(line).empty()) examples.push_back(words_of(line));
    if (line == "Example:") is_listed = true;
  }
  return examples;
}

/// What stands below "Options:" and "Arguments:", an entry for each, its further lines joined to
/// it.
std::vector<std::string> entries(const std::string& help) {
  std::vector<std::string> entries;
  bool is_listed = false;
  for (const std::string& line : lines_of(help)) {
    if (line.empty()) is_listed = false;
    if (is_listed && line.starts_with("   ")) {
      entries.back() += line.substr(line.find_first_not_of(' ') - 1);
    } else if (is_listed) {
      entries.push_back(line);
    }
    if (line == "Options:" || line == "Arguments:") is_listed = true;
  }
  return entries;
}

bool holds(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

// Each option that takes a value says what holds where it is not named, but for files that are then
// not written. What "not named" does is for the tests of each option to hold.
TEST(Help, SaysEveryDefaultAndNoRangeInSymbols) {
  std::size_t count = 0;
  for (const Words& command : all_commands()) {
    for (const std::string& entry : entries(help_of(command))) {
      const Words words = words_of(entry);
      std::size_t at = 0;
      while (words[at].ends_with(',')) ++at;  // -o, --output
      const bool is_argument = words[0].front() != '-';
      const bool takes_value =
          at + 1 < words.size() &&
          (words[at + 1] == "NUMBER" || words[at + 1] == "N" || words[at + 1] == "TEXT" ||
           words[at + 1] == "WORD" || words[at + 1] == "FILE");
      const bool may_be_silent = holds(entry, "; required") || words[at + 1] == "FILE";
      if (takes_value && !may_be_silent && !is_argument) {
        EXPECT_TRUE(holds(entry, "(default: ")) << testing::PrintToString(command) << entry;
        ++count;
      }
      for (const char* symbol : {" in [", " INT:", "FLOAT", ":{", "(default)", "where absent"}) {
        EXPECT_FALSE(holds(entry, symbol)) << testing::PrintToString(command) << entry;
      }
      EXPECT_EQ(entry.find("(default"), entry.rfind("(default")) << entry;
    }
  }
  EXPECT_GT(count, 80u);
}

/// A word alone may be longer than what is left of the line: a command of an example, a file.
bool is_wrapped(const std::string& line) {
  constexpr std::size_t kColumns = 80;
  return line.size() <= kColumns || words_of(line).size() == 1 ||
         line.starts_with("  torquewright");
}

TEST(Help, FitsAWindowOfEightyColumnsAndSaysNothingTwice) {
  for (const Words& command : all_commands()) {
    const std::string help = help_of(command);
    for (const std::string& line : lines_of(help)) {
      EXPECT_TRUE(is_wrapped(line)) << testing::PrintToString(command) << line;
    }
    for (const std::string& entry : entries(help)) {
      std::map<std::string, int> lists;
      for (const std::string& word : words_of(entry)) {
        if (word.ends_with(',') && word.find('_') != std::string::npos) ++lists[word];
      }
      for (const auto& [word, times] : lists) EXPECT_LT(times, 2) << entry;
    }
  }
}

// A sentence has a verb: none begins with the "of", "in" or "over" of a phrase that has none.
TEST(Help, SpeaksInSentences) {
  std::size_t count = 0;
  for (const Words& command : all_commands()) {
    const std::string help = help_of(command);
    for (const std::string& entry : entries(help)) {
      for (const char* start : {"  Of ", "  In which", "  Over ", "  Within", "  At which",
                                "  From a", "  Whose", "  After each", "  Also ", " repeatable"}) {
        EXPECT_FALSE(holds(entry, start)) << testing::PrintToString(command) << entry;
      }
      ++count;
    }
  }
  EXPECT_GT(count, 150u);
}

TEST(Help, IsPrintedWhereNothingElseIsAsked) {
  const std::string whole = help_of({});
  for (const Words& words : {Words{}, Words{"help"}, Words{"-h"}}) {
    EXPECT_EQ(run(words).out, whole);
    EXPECT_EQ(run(words).exit_code, 0);
  }
  const std::string gearbox = help_of({"gearbox"});
  for (const Words& words :
       {Words{"gearbox"}, Words{"help", "gearbox"}, Words{"gearbox", "help"}}) {
    EXPECT_EQ(run(words).out, gearbox);
  }
  EXPECT_EQ(run({"help", "gearbox", "optimize"}).out, help_of({"gearbox", "optimize"}));
}

TEST(Version, IsPrinted) {
  for (const char* option : {"-V", "--version"}) {
    EXPECT_EQ(run({option}).out, TORQUEWRIGHT_VERSION "\n");
    EXPECT_EQ(run({option}).exit_code, 0);
  }
}

TEST(Help, FindsTheCommands) {
  const std::vector<Words> commands = all_commands();
  for (const Words& known : {Words{}, Words{"gearbox"}, Words{"gearbox", "optimize"},
                             Words{"gearbox", "evaluate"}, Words{"gearbox", "verify"}}) {
    EXPECT_NE(std::find(commands.begin(), commands.end(), known), commands.end());
  }
}

TEST(Help, HoldsAnExampleThatRuns) {
  Workplace place;
  fs::copy(in_repository("specs"), place.path("specs"), fs::copy_options::recursive);
  for (const Words& command : all_commands()) {
    const std::vector<Words> found = examples(help_of(command));
    ASSERT_EQ(found.size(), 1u) << "of " << testing::PrintToString(command);
    const Words& example = found.front();
    ASSERT_GT(example.size(), command.size());
    EXPECT_EQ(example.front(), "torquewright");
    EXPECT_TRUE(std::equal(command.begin(), command.end(), example.begin() + 1));
    const Outcome outcome = place.run({example.begin() + 1, example.end()});
    // The flip asks for more than the hopper has: that is an answer too.
    const bool answers_no = command == Words{"hopper", "check"} ||
                            command == Words{"robot", "check"} || command == Words{"hopper"};
    EXPECT_EQ(outcome.exit_code, answers_no ? 1 : 0)
        << testing::PrintToString(example) << outcome.out;
    EXPECT_EQ(outcome.err, "") << testing::PrintToString(example);
    EXPECT_NE(outcome.out, "");
  }
}

bool is_one_line(const std::string& text) {
  return !text.empty() && text.find('\n') + 1 == text.size();
}

// Oracle: what the same example prints without either. What is no text for people (a table, a
// document, a page of help) is the answer itself and stays as it is; of a text -q leaves one line,
// and -v takes nothing away.
TEST(Help, HasExamplesThatAreQuietAndVerbose) {
  Workplace place;
  fs::copy(in_repository("specs"), place.path("specs"), fs::copy_options::recursive);
  std::size_t short_answers = 0;
  for (const Words& command : all_commands()) {
    const std::string help = help_of(command);
    if (!subcommands(help).empty() && command != Words{"identify"}) continue;  // leads to others
    EXPECT_TRUE(holds(help, "-q, --quiet")) << testing::PrintToString(command);
    EXPECT_TRUE(holds(help, "-v, --verbose")) << testing::PrintToString(command);
    Words example = examples(help).front();
    example.erase(example.begin());
    const Outcome usual = place.run(example);
    example.emplace_back("-q");
    const Outcome quiet = place.run(example);
    example.back() = "-v";
    const Outcome verbose = place.run(example);
    for (const Outcome* outcome : {&quiet, &verbose}) {
      EXPECT_EQ(outcome->exit_code, usual.exit_code) << testing::PrintToString(example);
      EXPECT_EQ(outcome->err, "") << testing::PrintToString(example);
    }
    EXPECT_TRUE(quiet.out == usual.out || is_one_line(quiet.out))
        << testing::PrintToString(example) << quiet.out;
    short_answers += quiet.out != usual.out;
    EXPECT_GE(verbose.out.size(), usual.out.size()) << testing::PrintToString(example);
    EXPECT_EQ(lines_of(verbose.out).front(), lines_of(usual.out).front());
  }
  EXPECT_GE(short_answers, 15u);
}

TEST(Help, SaysWhatVerboseAnswersRestOn) {
  const std::string file = in_specs("actuator/d151_knee.json");
  const Words words{"actuator", "mor", file};
  Words verbose = words;
  verbose.emplace_back("-v");
  const std::string more = run(verbose).out.substr(run(words).out.size());
  EXPECT_TRUE(more.starts_with("read: " + file + ", of kind actuator; it assumes /")) << more;
  EXPECT_EQ(run({"actuator", "mor", file, "-q", "-v"}).exit_code, 2);
  EXPECT_EQ(run({"actuator", "lint", file, "-q"}).out.find(": "), 4u);  // pass: or fail:
}

}  // namespace
}  // namespace torquewright::cli_test
