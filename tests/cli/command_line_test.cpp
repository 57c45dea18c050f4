// SPDX-License-Identifier: Apache-2.0
// What the interface to the parser of command lines promises. Oracle: its own header, word for
// word; that help and refusals reach the user as they did is for the tests of the built program.
#include "src/command_line/command_line.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <new>
#include <optional>
#include <stdexcept>

#include "io/faults/spec_error.hpp"
#include "src/command_line/exit_status.hpp"

namespace torquewright::command_line {
namespace {

using cli::ExitCode;

ExitCode run(Program& program, std::vector<const char*> words) {
  words.insert(words.begin(), "program");
  return program.run(static_cast<int>(words.size()), words.data());
}

/// What the refusal says; empty where the words are understood.
std::string refusal(Program& program, const std::vector<const char*>& words) {
  try {
    run(program, words);
  } catch (const io::SpecError& error) {
    return error.what();
  }
  return "";
}

TEST(CommandLine, FillsEveryKindOfValue) {
  Program program("program", "");
  Command& top = program.top();
  std::string text;
  double number = 0.0;
  std::optional<double> maybe, never;
  int small = 0;
  std::int64_t whole = 0;
  std::uint64_t seed = 0;
  std::vector<std::string> texts;
  std::vector<double> numbers;
  std::vector<std::int64_t> counts;
  bool is_on = false, is_checked = true;
  top.add_option("place", text, "");
  top.add_option("--number", number, "");
  top.add_option("--maybe", maybe, "");
  top.add_option("--never", never, "");
  top.add_option("--small", small, "");
  top.add_option("--whole", whole, "");
  top.add_option("--seed", seed, "");
  top.add_option("--texts", texts, "").one_value_each();
  top.add_option("--numbers", numbers, "").separated_by_commas();
  top.add_option("--counts", counts, "").takes(3);
  top.add_flag("--on", is_on, "");
  top.add_flag("!--no-check", is_checked, "");
  run(program, {"--number", "1.5",        "--maybe", "2.5",    "--small",
                "-3",       "--whole",    "-4",      "--seed", "18446744073709551615",
                "--texts",  "a",          "--texts", "b",      "--numbers",
                "1,2",      "--counts",   "5",       "6",      "7",
                "--on",     "--no-check", "here"});
  EXPECT_EQ(text, "here");
  EXPECT_EQ(number, 1.5);
  EXPECT_EQ(maybe, 2.5);
  EXPECT_EQ(never, std::nullopt);
  EXPECT_EQ(small, -3);
  EXPECT_EQ(whole, -4);
  EXPECT_EQ(seed, 18446744073709551615u);
  EXPECT_EQ(texts, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(numbers, (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(counts, (std::vector<std::int64_t>{5, 6, 7}));
  EXPECT_TRUE(is_on);
  EXPECT_FALSE(is_checked);
}

TEST(CommandLine, LetsANamedCommandWorkInPlaceOfTheOneAboveIt) {
  Program program("program", "");
  Command above = program.top().add_command("above", "");
  Command below = above.add_command("below", "");
  above.works([] { return ExitCode::kFails; });
  below.works([] { return ExitCode::kUndecided; });
  EXPECT_EQ(run(program, {"above"}), ExitCode::kFails);
  Program other("program", "");
  above = other.top().add_command("above", "");
  below = above.add_command("below", "");
  above.works([] { return ExitCode::kFails; });
  below.works([] { return ExitCode::kUndecided; });
  EXPECT_EQ(run(other, {"above", "below"}), ExitCode::kUndecided);
}

TEST(CommandLine, WorksOnlyWhenAllWordsAreUnderstood) {
  Program program("program", "");
  bool has_worked = false;
  Command command = program.top().add_command("command", "");
  program.top().require_command();
  command.works([&] {
    has_worked = true;
    return ExitCode::kPasses;
  });
  EXPECT_EQ(refusal(program, {"command", "more"}),
            "command line: The following argument was not expected: more; it is program command "
            "[OPTIONS]; --help shows what is allowed");
  EXPECT_FALSE(has_worked);
}

struct Bounded {
  Program program{"program", ""};
  double strict = 0.0, free = 0.0;
  std::optional<double> maybe;
  std::vector<double> list;
  std::int64_t whole = 0;
  std::string word, file;
  Bounded() {
    Command& top = program.top();
    top.add_option("--strict", strict, "").between(1.0, 2.0);
    top.add_option("--free", free, "");
    top.add_option("--maybe", maybe, "").positive();
    top.add_option("--list", list, "").separated_by_commas();
    top.add_option("--whole", whole, "").integer_between(1, 2);
    top.add_option("--word", word, "").one_of({"a", "b"}).excludes("--free");
    top.add_option("--file", file, "").names_a_file().needs("--word");
  }
};

TEST(CommandLine, RefusesWhatLiesOutside) {
  for (const auto& words : std::vector<std::vector<const char*>>{{"--strict", "0.999"},
                                                                 {"--strict", "2.001"},
                                                                 {"--strict", "nan"},
                                                                 {"--free", "inf"},
                                                                 {"--free", "-nan"},
                                                                 {"--maybe", "nan"},
                                                                 {"--maybe", "infinity"},
                                                                 {"--list", "1,nan,2"},
                                                                 {"--whole", "0"},
                                                                 {"--whole", "3"},
                                                                 {"--whole", "1.5"},
                                                                 {"--word", "c"},
                                                                 {"--word", "a", "--free", "1"},
                                                                 {"--file", "f"},
                                                                 {"--word", "a", "--file", ""}}) {
    Bounded bounded;
    EXPECT_NE(refusal(bounded.program, words), "") << testing::PrintToString(words);
  }
}

TEST(CommandLine, TakesBothEndsAndWhatBelongsTogether) {
  for (const auto& words :
       std::vector<std::vector<const char*>>{{"--strict", "2", "--whole", "1"},
                                             {"--strict", "1", "--whole", "2"},
                                             {"--free", "-1e9", "--list", "1,2"},
                                             {"--word", "b", "--file", "f"}}) {
    Bounded bounded;
    EXPECT_EQ(refusal(bounded.program, words), "") << testing::PrintToString(words);
  }
}

TEST(ExitStatus, IsTheWorksOwnOrTellsWhatStoppedIt) {
  EXPECT_EQ(exit_status([] { return ExitCode::kPasses; }), 0);
  EXPECT_EQ(exit_status([] { return ExitCode::kFails; }), 1);
  EXPECT_EQ(exit_status([] { return ExitCode::kUndecided; }), 3);
  testing::internal::CaptureStderr();
  EXPECT_EQ(exit_status([]() -> ExitCode { refuse("x is missing"); }), 2);
  EXPECT_EQ(exit_status([]() -> ExitCode {
              throw std::filesystem::filesystem_error(
                  "gone", std::make_error_code(std::errc::no_such_file_or_directory));
            }),
            2);
  EXPECT_EQ(exit_status([]() -> ExitCode { throw std::bad_alloc(); }), 2);
  EXPECT_EQ(exit_status([]() -> ExitCode { throw std::runtime_error("odd"); }), 70);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "command line: x is missing; --help shows what is allowed\n"
            "the current folder: cannot be reached: No such file or directory\n"
            "memory: what is asked for takes more than the system gives; a shorter input, fewer "
            "--threads or --jobs, or a higher limit (ulimit -v) may do\n"
            "internal error: odd\n");
}

}  // namespace
}  // namespace torquewright::command_line
