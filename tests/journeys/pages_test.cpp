// SPDX-License-Identifier: Apache-2.0
// What a page shows is what the program prints. Oracle: the program, run as the page says, command
// after command in one folder.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cli/workplace.hpp"
#include "tests/journeys/shown_commands.hpp"

namespace torquewright::journeys {
namespace {

namespace fs = std::filesystem;

// Solvers end elsewhere in the last digits on another processor, and the least of many like
// things may be another one.
constexpr double kShare = 0.1;

class Pages : public testing::TestWithParam<const char*> {
 protected:
  Pages() {
    workplace.here.folder = workplace.path("root");
    fs::create_directory(workplace.here.folder);
    fs::create_directory_symlink(cli_test::in_repository("specs"), workplace.path("root/specs"));
    fs::create_directory_symlink(cli_test::in_repository("../shared"), workplace.path("shared"));
  }

  /// Recorded motions are not in the repository.
  static bool is_here(const std::string& argument) {
    return !argument.starts_with("../") || fs::exists(cli_test::in_repository(argument));
  }

  cli_test::Workplace workplace;
};

TEST_P(Pages, ShowWhatIsPrinted) {
  const std::string page = cli_test::text_of(cli_test::in_repository(GetParam()));
  std::size_t played = 0;
  for (const ShownCommand& command : commands_of(page)) {
    std::string words;
    for (const std::string& argument : command.arguments) words += " " + argument;
    if (!std::all_of(command.arguments.begin(), command.arguments.end(), is_here)) continue;
    const cli_test::Outcome outcome = workplace.run(command.arguments);
    EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1)
        << words << " ends with " << outcome.exit_code << ": " << outcome.err;
    const std::string missing = first_unprinted(command.printed, outcome.out + outcome.err, kShare);
    EXPECT_EQ(missing, "") << words << "\nprints\n" << outcome.out << outcome.err;
    ++played;
  }
  EXPECT_GE(played, 2u);
}

INSTANTIATE_TEST_SUITE_P(ReadMe, Pages, testing::Values("README.md"));
INSTANTIATE_TEST_SUITE_P(Gearbox, Pages, testing::Values("docs/gearbox.md"));
INSTANTIATE_TEST_SUITE_P(Actuator, Pages, testing::Values("docs/actuator.md"));
INSTANTIATE_TEST_SUITE_P(Model, Pages, testing::Values("docs/model.md"));
INSTANTIATE_TEST_SUITE_P(Training, Pages, testing::Values("docs/training.md"));
INSTANTIATE_TEST_SUITE_P(Motion, Pages, testing::Values("docs/motion.md"));

TEST(ShownCommands, AreReadFromIndentedBlocks) {
  const auto commands = commands_of(
      "Text:\n\n    torquewright a b\n\n    first\n      second\n\nText.\n\n    none\n\n"
      "    torquewright c\n    torquewright d\n    third\n");
  ASSERT_EQ(commands.size(), 3u);
  EXPECT_EQ(commands[0].arguments, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(commands[0].printed, (std::vector<std::string>{"first", "  second"}));
  EXPECT_TRUE(commands[1].printed.empty());
  EXPECT_EQ(commands[2].printed, std::vector<std::string>{"third"});
}

TEST(ShownCommands, AreHeldAgainstLinesInOrder) {
  const std::string output = "one 1.00\n\ntwo   words\nthree 300 Nm\nfour and more\n";
  const auto missing = [&](const std::vector<std::string>& shown) {
    return first_unprinted(shown, output, 0.1);
  };
  EXPECT_EQ(missing({"one 1.05", "two words"}), "");
  EXPECT_EQ(missing({"one 1.2"}), "one 1.2");
  EXPECT_EQ(missing({"...", "three 310 Nm", "four ..."}), "");
  EXPECT_EQ(missing({"one 1", "three 300 Nm"}), "three 300 Nm");  // nothing may be left out
  EXPECT_EQ(missing({"...", "three 300 Nm", "...", "two words"}), "two words");  // in order
  EXPECT_EQ(missing({"...", "three 300 rad"}), "three 300 rad");
}

}  // namespace
}  // namespace torquewright::journeys
