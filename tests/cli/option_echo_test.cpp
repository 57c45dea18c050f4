// SPDX-License-Identifier: Apache-2.0
// What results state of a command's options. Oracle: the headers' words (command_line.hpp,
// option_echo.hpp), option by option.
#include "src/command_line/option_echo.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "src/command_line/command_line.hpp"

namespace torquewright::command_line {
namespace {

/// Every way in which an option may be stated.
struct Echoing {
  Program program{"program", ""};
  double step_s = 0.5, period_s = 2.0;
  std::optional<double> height_m;
  int runs = 1;
  std::vector<std::string> names;
  std::string engine = "own", picture;
  bool denies = false;

  Echoing() {
    Command& top = program.top();
    top.add_option("--step", step_s, "").stated_as("step_s", 1);
    top.add_option("--height", height_m, "").stated_as("height_m");
    top.add_option("--runs", runs, "").stated_as("runs");
    top.add_option("--name", names, "").one_value_each().always_stated_as("name");
    top.add_option("--engine", engine, "").stated_elsewhere_as("engine", -1);
    top.add_flag("--without", denies, "").stated_as_not("with");
    top.add_option("-p,--picture", picture, "").of_one_answer();
    top.add_option("--period", period_s, "");  // no result states it
  }

  const DeclaredCommand& after(std::vector<const char*> words) {
    words.insert(words.begin(), "program");
    program.run(static_cast<int>(words.size()), words.data());
    return program.top().declared();
  }
};

std::vector<std::string> keys_of(const std::vector<EchoedOption>& options) {
  std::vector<std::string> keys;
  for (const EchoedOption& option : options) keys.push_back(option.key);
  return keys;
}

TEST(OptionEcho, IsOfWhatIsNotUsualOrAlwaysStated) {
  Echoing nothing, usual, all;
  using Keys = std::vector<std::string>;
  EXPECT_EQ(keys_of(echoed_options(nothing.after({}))), Keys{"name"});
  EXPECT_EQ(keys_of(echoed_options(usual.after({"--step", "0.5", "--runs", "1"}))), Keys{"name"});
  const DeclaredCommand& command =
      all.after({"--step", "0.25", "--height", "0", "--runs", "2", "--engine", "mujoco",
                 "--without", "--period", "3", "--name", "a"});
  EXPECT_EQ(keys_of(echoed_options(command)), (Keys{"height_m", "runs", "name", "with", "step_s"}));
}

TEST(OptionEcho, HoldsTheValuesThatWereRead) {
  Echoing all;
  const auto echoed = echoed_options(
      all.after({"--step", "0.25", "--height", "0", "--runs", "2", "--without", "--name", "a"}));
  ASSERT_EQ(echoed.size(), 5u);
  EXPECT_EQ(echoed[0].value, OptionValue(0.0));
  EXPECT_EQ(echoed[1].value, OptionValue(std::int64_t{2}));
  EXPECT_EQ(echoed[2].value, OptionValue(std::vector<std::string>{"a"}));
  EXPECT_EQ(echoed[3].value, OptionValue(false));
  EXPECT_EQ(echoed[4].value, OptionValue(0.25));
}

TEST(OptionEcho, OfAFingerprintHasWhatTheResultStatesElsewhereInItsPlace) {
  Echoing usual;
  const auto counted = counted_options(usual.after({"--runs", "2"}));
  EXPECT_EQ(keys_of(counted), (std::vector<std::string>{"engine", "runs", "name"}));
  EXPECT_EQ(counted[0].value, OptionValue(std::string("own")));
}

TEST(OptionEcho, NamesWhatIsOfOneAnswerWhereItWasAskedFor) {
  Echoing without, with;
  EXPECT_TRUE(named_of_one_answer(without.after({"--runs", "2"})).empty());
  EXPECT_EQ(named_of_one_answer(with.after({"-p", "x.svg"})),
            std::vector<std::string>{"--picture"});
}

}  // namespace
}  // namespace torquewright::command_line
