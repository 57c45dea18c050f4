// SPDX-License-Identifier: Apache-2.0
// What a window shows beside answers: completion by Tab, progress that is taken back, an end by
// Ctrl-C. Oracles: what the shell was typed, and what the same command writes where nobody watches.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <ostream>
#include <set>
#include <sstream>
#include <thread>

#include "tests/cli/workplace.hpp"
#include "tests/journeys/terminal.hpp"

namespace torquewright::journeys {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

class Window : public testing::Test {
 protected:
  void SetUp() override {
    if (!Terminal::is_installed()) GTEST_SKIP() << "tmux is not installed";
    fs::create_directory_symlink(cli_test::in_repository("specs"), place_.path("specs"));
  }

  cli_test::Workplace place_;
};

Words words_in(const std::string& text) {
  std::istringstream stream(text);
  Words words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::string joined(const Words& lines, std::size_t from) {
  std::string text;
  for (std::size_t i = from; i < lines.size(); ++i) text += lines[i] + "\n";
  return text;
}

TEST_F(Window, TabCompletesCommandsAndOptions) {
  Terminal terminal(place_.path(), TORQUEWRIGHT_PROGRAM, kColumns, kRows);
  EXPECT_EQ(terminal.run({"source <(torquewright completion bash)"}).exit_code, 0);
  terminal.type("torquewright gea");
  terminal.press("Tab");
  EXPECT_TRUE(terminal.comes("$ torquewright gearbox"));
  terminal.type("opt");
  terminal.press("Tab");
  EXPECT_TRUE(terminal.comes("$ torquewright gearbox optimize"));
  terminal.type("specs/gearbox/d151_knee.json --veri");
  terminal.press("Tab");
  EXPECT_TRUE(
      terminal.comes("$ torquewright gearbox optimize specs/gearbox/d151_knee.json --verify"));
  terminal.press("Enter");
  const Screen screen = terminal.wait();
  EXPECT_EQ(screen.exit_code, 0);
  EXPECT_NE(joined(screen.lines, 0).find("accepted: 44/44/32/132/120"), std::string::npos);
}

// The words that stand in the window are those of the file, though the window breaks no line and
// a progress line came and went.
TEST_F(Window, ProgressLeavesNothingBehind) {
  const std::string command =
      "torquewright identify specs/log/bench_as_built.csv --rig specs/log/bench_rig.json "
      "--actuator specs/log/bench_actuator.json";
  Terminal terminal(place_.path(), TORQUEWRIGHT_PROGRAM, kColumns, kRows);
  const Screen watched = terminal.run({command});
  ASSERT_EQ(terminal.run({command + " > written.txt 2> problems.txt"}).exit_code, 0);
  EXPECT_EQ(place_.text("problems.txt"), "");
  EXPECT_EQ(words_in(joined(watched.lines, 1)), words_in(place_.text("written.txt")));
  const std::size_t typed = watched.rows.size() - watched.lines.size();
  EXPECT_EQ(typed, (command.size() + 2) / kColumns);  // nothing but the command was broken
}

TEST_F(Window, CtrlCLeavesAPromptAndNoFiles) {
  Terminal terminal(place_.path(), TORQUEWRIGHT_PROGRAM, kColumns, kRows);
  const auto before = place_.files();
  terminal.type("torquewright hopper flip specs/robot/hopper.json -o plan.csv --figures plan.svg");
  terminal.press("Enter");
  ASSERT_TRUE(terminal.comes("intervals, iteration 1"));  // whose line is longer than a row
  terminal.press("C-c");
  const Screen screen = terminal.wait();
  EXPECT_EQ(screen.exit_code, 3);
  std::set<std::string> left;
  for (const auto& [name, text] : place_.files()) left.insert(name);
  EXPECT_EQ(left, std::set<std::string>{"specs"});
  EXPECT_EQ(place_.files(), before);
  for (const std::string& row : screen.rows) {
    EXPECT_EQ(row.find("intervals, iteration "), std::string::npos) << row;
  }
  EXPECT_EQ(terminal.run({"echo still here"}).lines.back(), "still here");
}

constexpr const char* kCheck =
    "torquewright actuator check specs/trajectory/knee_extension.csv --joint "
    "knee=specs/actuator/d151_knee.json";

std::size_t escapes_in(const Words& rows) {
  std::size_t count = 0;
  for (const std::string& row : rows) {
    count += static_cast<std::size_t>(std::count(row.begin(), row.end(), '\033'));
  }
  return count;
}

// Oracle: the escapes that the emulator keeps, 32 for green (ECMA-48, 8.3.117), and no-color.org.
// Without colours the rows hold the same.
TEST_F(Window, ColoursVerdictsWhereTheTerminalAndItsUserWantThem) {
  Terminal terminal(place_.path(), TORQUEWRIGHT_PROGRAM, kColumns, kRows);
  terminal.run({"export TERM=screen; unset NO_COLOR; clear"});
  const Screen screen = terminal.run({kCheck});
  ASSERT_EQ(screen.exit_code, 0);
  const std::string rows = joined(terminal.coloured(), 0);
  EXPECT_NE(rows.find("specs/trajectory/knee_extension.csv: \033[32mpass"), std::string::npos)
      << rows;
  for (const char* plain : {"NO_COLOR=1 ", "TERM=dumb "}) {
    terminal.run({"clear"});
    const Screen bare = terminal.run({std::string(plain) + kCheck});
    EXPECT_EQ(escapes_in(terminal.coloured()), 0u) << plain;
    EXPECT_EQ(joined(bare.lines, 1), joined(screen.lines, 1)) << plain;
  }
  terminal.run({std::string(kCheck) + " > written.txt"});
  EXPECT_EQ(place_.text("written.txt").find('\033'), std::string::npos);
}

TEST_F(Window, QuietWorkShowsNoProgress) {
  Terminal terminal(place_.path(), TORQUEWRIGHT_PROGRAM, kColumns, kRows);
  const Screen screen = terminal.run(
      {"torquewright identify specs/log/bench_as_built.csv --rig specs/log/bench_rig.json "
       "--actuator specs/log/bench_actuator.json -q 2> problems.txt"});
  EXPECT_EQ(screen.exit_code, 0);
  EXPECT_EQ(screen.lines.size(), 2u) << joined(screen.lines, 0);  // what was typed, and the answer
  EXPECT_EQ(place_.text("problems.txt"), "");
}

// A picture follows its document: the region's title has the torque at rest that the document
// makes.
TEST_F(Window, WatchedPicturesFollowTheirDocument) {
  const std::string document =
      cli_test::text_of(cli_test::in_repository("specs/actuator/d110a_ankle.json"));
  place_.write("drive.json", document);
  Terminal terminal(place_.path(), TORQUEWRIGHT_PROGRAM, kColumns, kRows);
  terminal.type("torquewright actuator mor drive.json --plot region.svg --watch");
  terminal.press("Enter");
  ASSERT_TRUE(terminal.comes("watching 1 file; Ctrl-C ends it"));
  const std::string first = place_.text("region.svg");
  place_.write("drive.json", "{");  // as an editor that has not ended
  ASSERT_TRUE(terminal.comes("not JSON"));
  EXPECT_EQ(place_.text("region.svg"), first);
  const std::string half = cli_test::with(document, "\"bus_voltage_V\": ", "\"bus_voltage_V\": 1");
  place_.write("drive.json", half);
  std::string second = first;
  for (int look = 0; look < 100 && second == first; ++look) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    second = place_.text("region.svg");
  }
  EXPECT_NE(second, first);
  terminal.press("C-c");
  EXPECT_EQ(terminal.wait().exit_code, 0);
  EXPECT_EQ(terminal.run({"torquewright actuator mor drive.json --plot again.svg"}).exit_code, 0);
  EXPECT_EQ(place_.text("again.svg"), second);
}

/// A command that watches, the copy of an input that is changed, and what it writes.
struct Watched {
  const char* what;
  std::string command;
  const char* input;
  const char* output;
};
void PrintTo(const Watched& watched, std::ostream* out) { *out << watched.what; }

class WatchedMotion : public Window, public testing::WithParamInterface<Watched> {};

// Oracle: the same command without --watch, on the motion as it is then.
TEST_P(WatchedMotion, IsDrawnAgain) {
  const Watched& watched = GetParam();
  const std::string motion =
      cli_test::text_of(cli_test::in_repository(std::string("specs/trajectory/") + watched.input));
  place_.write("motion.csv", motion);
  Terminal terminal(place_.path(), TORQUEWRIGHT_PROGRAM, kColumns, kRows);
  terminal.type(watched.command + " --watch > said.txt");
  terminal.press("Enter");
  ASSERT_TRUE(terminal.comes("Ctrl-C ends it"));
  const std::string first = place_.text(watched.output);
  place_.write("motion.csv", motion.substr(0, motion.rfind('\n', motion.size() - 2) + 1));
  std::string second = first;
  for (int look = 0; look < 300 && second == first; ++look) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    second = place_.text(watched.output);
  }
  EXPECT_NE(second, first);
  terminal.press("C-c");
  const int code = terminal.wait().exit_code;
  EXPECT_EQ(terminal.run({watched.command + " > again.txt"}).exit_code, code);
  EXPECT_EQ(place_.text(watched.output), second);
}

INSTANTIATE_TEST_SUITE_P(
    Window, WatchedMotion,
    testing::Values(
        Watched{"a picture of one drive",
                "torquewright actuator check motion.csv --joint knee=specs/actuator/d151_knee.json "
                "--plot check.svg",
                "knee_extension.csv", "check.svg"},
        Watched{"a robot's page",
                "torquewright hopper check specs/robot/hopper.json motion.csv --report page.html",
                "hopper_squat.csv", "page.html"}));

}  // namespace
}  // namespace torquewright::journeys
