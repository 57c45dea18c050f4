// SPDX-License-Identifier: Apache-2.0
// Completion scripts and pages for man. Oracle: bash itself, which runs the script; man and groff,
// which must have nothing to warn of; and the help of every command.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <sstream>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using Words = std::vector<std::string>;

/// What a line of sh prints to stdout and stderr together.
std::string said_by_shell(const std::string& line) {
  FILE* pipe = popen(("{ " + line + " ; } 2>&1").c_str(), "r");
  std::string text;
  std::array<char, 4096> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), pipe)) text += buffer.data();
  pclose(pipe);
  return text;
}

bool has_program(const std::string& name) { return !said_by_shell("command -v " + name).empty(); }

Words words_of(const std::string& text) {
  std::istringstream stream(text);
  Words words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::string quoted(const std::string& word) { return "'" + word + "'"; }

/// What bash offers for the last of the words.
Words offered_by_bash(const Workplace& place, const Words& words) {
  std::string array;
  for (const std::string& word : words) array += " " + quoted(word);
  const std::string line =
      "source " + quoted(place.path("completion.bash")) + "; COMP_WORDS=(torquewright" + array +
      "); COMP_CWORD=" + std::to_string(words.size()) + "; _torquewright; echo \"${COMPREPLY[@]}\"";
  const fs::path script = place.write("ask.bash", line + "\n");
  return words_of(said_by_shell("bash " + quoted(script.string())));
}

struct CompletionPlace : Workplace {
  CompletionPlace() { write("completion.bash", run({"completion", "bash"}).out); }
};

TEST(BashCompletion, OffersCommandsOptionsAndWords) {
  if (!has_program("bash")) GTEST_SKIP() << "bash is not installed";
  const CompletionPlace place;
  EXPECT_EQ(offered_by_bash(place, {"gear"}), Words{"gearbox"});
  EXPECT_EQ(
      offered_by_bash(place, {"gearbox", ""}),
      (Words{"optimize", "evaluate", "verify", "strength", "pareto", "drawing", "tolerances"}));
  EXPECT_EQ(offered_by_bash(place, {"gearbox", "optimize", "knee.json", "--rel"}),
            Words{"--relaxation"});
  EXPECT_EQ(offered_by_bash(place, {"gearbox", "optimize", "--relaxation", ""}),
            (Words{"auto", "always", "never"}));
  EXPECT_EQ(offered_by_bash(place, {"actuator", "mor", "a.json", "--side", "m"}), Words{"motor"});
  EXPECT_EQ(offered_by_bash(place, {"init", "gear"}),
            (Words{"gear_strength", "gearbox", "gearbox_problem"}));
  EXPECT_EQ(offered_by_bash(place, {"identify", "--rig", "residual", "--emp"}),
            Words{"--empirical"});  // "residual" is the file's name
  EXPECT_EQ(offered_by_bash(place, {"identify", "residual", "--emp"}), Words{});
  EXPECT_EQ(offered_by_bash(place, {"gearbox", "optimize", ""}), Words{});  // files
}

TEST(BashCompletion, OffersEveryOptionOfTheHelp) {
  if (!has_program("bash")) GTEST_SKIP() << "bash is not installed";
  const CompletionPlace place;
  for (const Words& command :
       {Words{"hopper", "replay"}, Words{"actuator", "mor"}, Words{"identify"}, Words{}}) {
    Words asked = command;
    asked.push_back("-");
    const Words offered = offered_by_bash(place, asked);
    Words help = command;
    help.push_back("--help");
    Words listed;
    std::istringstream lines(run(help).out);
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with("  -")) continue;
      for (std::string word : words_of(line)) {
        if (word.front() != '-') break;
        if (word.back() == ',') word.pop_back();
        listed.push_back(word);
      }
    }
    EXPECT_EQ(offered, listed) << testing::PrintToString(command);
  }
}

TEST(Completion, IsAScriptThatItsShellReads) {
  for (const char* shell : {"bash", "zsh", "fish"}) {
    const Workplace place;
    const Outcome outcome = place.run({"completion", shell, "-o", "script"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_NE(place.text("script").find("torquewright"), std::string::npos);
    if (!has_program(shell)) continue;
    EXPECT_EQ(said_by_shell(std::string(shell) + " -n " + quoted(place.path("script").string())),
              "")
        << shell;
  }
}

/// "gearbox optimize", ...: every command that the help leads to.
std::vector<Words> all_commands(const Words& from = {}) {
  std::vector<Words> commands{from};
  Words help = from;
  help.push_back("--help");
  std::istringstream lines(run(help).out);
  bool is_listed = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) is_listed = false;
    if (is_listed && line.starts_with("  ") && line[2] != ' ') {
      Words command = from;
      command.push_back(words_of(line).front());
      for (const Words& each : all_commands(command)) commands.push_back(each);
    }
    if (line == "Commands:") is_listed = true;
  }
  return commands;
}

TEST(ManPages, AreReadWithoutAWarning) {
  const bool has_groff = has_program("groff"), has_man = has_program("man");
  if (!has_groff && !has_man) GTEST_SKIP() << "neither groff nor man is installed";
  for (const Words& command : all_commands()) {
    const Workplace place;
    Words man = {"man"};
    man.insert(man.end(), command.begin(), command.end());
    const fs::path page = place.write("page.1", run(man).out);
    if (has_groff) {
      EXPECT_EQ(said_by_shell("groff -man -ww -Tutf8 -rLL=300n " + quoted(page.string()) + " > " +
                              quoted(place.path("shown"))),
                "")
          << testing::PrintToString(command);
    }
    if (has_man) {
      const std::string shown =
          said_by_shell("MANWIDTH=200 man -l " + quoted(page.string()) + " | cat");
      EXPECT_NE(shown.find("EXIT STATUS"), std::string::npos) << shown;
    }
  }
}

TEST(ManPages, HoldEveryOptionOfTheHelp) {
  const std::string page = run({"man", "hopper", "replay"}).out;
  std::istringstream lines(run({"hopper", "replay", "--help"}).out);
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  --")) continue;
    std::string name = words_of(line).front();
    for (std::size_t at = 0; (at = name.find('-', at)) != std::string::npos; at += 2) {
      name.insert(at, "\\");
    }
    EXPECT_NE(page.find("\\fB" + name + "\\fR"), std::string::npos) << name;
    ++count;
  }
  EXPECT_GT(count, 30u);
}

TEST(ManPages, AreWrittenOfAllCommandsIntoAFolder) {
  const Workplace place;
  EXPECT_EQ(place.run({"man", "--all", "."}).exit_code, 0);
  std::size_t count = 0;
  for (const Words& command : all_commands()) {
    std::string name = "torquewright";
    for (const std::string& word : command) name += "-" + word;
    Words man = {"man"};
    man.insert(man.end(), command.begin(), command.end());
    ASSERT_TRUE(place.has(name + ".1")) << name;
    EXPECT_EQ(place.text(name + ".1"), run(man).out);
    ++count;
  }
  EXPECT_EQ(place.files().size(), count);
}

TEST(ManPages, AreOfAllCommandsOrOfOne) {
  const Workplace place;
  EXPECT_EQ(place.run({"man", "gearbox", "--all", "."}).exit_code, 2);
  EXPECT_EQ(place.run({"man", "--all", ".", "-o", "page.1"}).exit_code, 2);
  EXPECT_EQ(place.run({"man", "--all", ""}).exit_code, 2);
  const Outcome outcome = place.run({"man", "--all", "nowhere"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("nowhere"), std::string::npos);
  EXPECT_TRUE(place.files().empty());
}

}  // namespace
}  // namespace torquewright::cli_test
