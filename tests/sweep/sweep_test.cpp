// SPDX-License-Identifier: Apache-2.0
// Sweeps by processes. Oracle: the squares that toy_sweep's rows are, and the points that it wrote
// into its diary when it did them.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <map>
#include <thread>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using std::chrono::milliseconds;

/// What a sweep of so many points prints, but for those points.
std::string squares(int points, const std::map<int, std::string>& others = {}) {
  static const char* const kThirds[] = {"0", "0.3333333333333333", "0.6666666666666666",
                                        "1", "1.3333333333333333", "1.6666666666666667",
                                        "2", "2.3333333333333335", "2.6666666666666665",
                                        "3", "3.3333333333333335", "3.6666666666666665"};
  std::string text;
  for (int i = 0; i < points; ++i) {
    text += "number=" + std::to_string(i) + " ";
    const auto other = others.find(i);
    text += other != others.end()
                ? other->second
                : R"({"square":)" + std::to_string(i * i) + R"(,"third":)" + kThirds[i] + "}";
    text += "\n";
  }
  return text;
}

std::vector<int> diary(const Workplace& place) {
  std::vector<int> points;
  std::istringstream lines(place.text("diary"));
  for (int point = 0; lines >> point;) points.push_back(point);
  std::sort(points.begin(), points.end());
  return points;
}

std::vector<int> all_of(int points) {
  std::vector<int> all;
  for (int i = 0; i < points; ++i) all.push_back(i);
  return all;
}

TEST(Sweep, SaysTheSameByAnyNumberOfProcesses) {
  for (const char* jobs : {"1", "2", "3", "8"}) {
    const Workplace place;
    const Outcome outcome =
        place.run({"--points", "9", "--jobs", jobs, "--journal", "journal", "--diary", "diary"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, squares(9)) << jobs;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(diary(place), all_of(9));
  }
}

TEST(Sweep, NeedsNoJournal) {
  const Workplace place;
  EXPECT_EQ(place.run({"--points", "4"}).out, squares(4));
  EXPECT_TRUE(place.files().empty());
}

TEST(Sweep, DoesNothingTwice) {
  const Workplace place;
  EXPECT_EQ(place.run({"--points", "4", "--journal", "journal", "--diary", "diary"}).exit_code, 0);
  const std::string journal = place.text("journal");
  const Outcome again =
      place.run({"--points", "6", "--journal", "journal", "--diary", "diary", "--jobs", "2"});
  EXPECT_EQ(again.out, squares(6));
  EXPECT_EQ(diary(place), all_of(6));
  EXPECT_TRUE(place.text("journal").starts_with(journal));
}

TEST(Sweep, TakesNothingFromAnotherRequest) {
  const Workplace place;
  place.run({"--points", "3", "--journal", "journal"});
  place.run({"--points", "3", "--journal", "journal", "--request", "other", "--diary", "diary"});
  EXPECT_EQ(diary(place), all_of(3));
}

TEST(Sweep, LosesThePointOfAProcessThatIsKilled) {
  for (const char* jobs : {"1", "3"}) {
    const Workplace place;
    const Outcome outcome =
        place.run({"--points", "8", "--jobs", jobs, "--journal", "journal", "--killed", "5"});
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_EQ(outcome.out, squares(8, {{5, "lost: its process was ended by signal 9 (Killed)"}}));
    const Outcome again =
        place.run({"--points", "8", "--jobs", jobs, "--journal", "journal", "--diary", "diary"});
    EXPECT_EQ(again.exit_code, 0);
    EXPECT_EQ(again.out, squares(8));
    EXPECT_EQ(diary(place), std::vector<int>{5});
  }
}

TEST(Sweep, LosesAPointThatThrows) {
  const Workplace place;
  const Outcome outcome = place.run({"--points", "4", "--thrown", "0", "--jobs", "2"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(outcome.out, squares(4, {{0, "lost: point of trouble"}}));
}

TEST(Sweep, IgnoresWhatIsNoLineOfItsJournal) {
  const Workplace place;
  place.run({"--points", "3", "--journal", "journal"});
  std::string journal = place.text("journal");
  journal.resize(journal.size() - 7);  // the last line, half written
  const std::size_t second = journal.find('\n') + 1;
  journal.insert(second, "{\"point\": 1\nnull\n[]\n{\"point\": 7, \"request\": \"toy\"}\n");
  place.write("journal", journal);
  const Outcome again = place.run({"--points", "3", "--journal", "journal", "--diary", "diary"});
  EXPECT_EQ(again.out, squares(3)) << again.err;
  EXPECT_EQ(diary(place), std::vector<int>{2});
}

// Oracle: the answer without a journal, whatever byte of it has been changed.
TEST(Sweep, BelievesNoLineThatHasBeenChanged) {
  const Workplace place;
  const std::vector<std::string> command{"--points", "3", "--journal", "journal"};
  ASSERT_EQ(place.run(command).exit_code, 0);
  const std::string journal = place.text("journal");
  for (std::size_t at = journal.find('\n') + 1; at < journal.size(); at += 7) {
    std::string changed = journal;
    changed[at] = changed[at] == '1' ? '2' : '1';
    place.write("journal", changed);
    EXPECT_EQ(place.run(command).out, squares(3)) << at;
  }
}

// Its workers end with it: nothing is done any more after it.
TEST(Sweep, GoesOnWhereItWasKilled) {
  const Workplace place;
  const std::vector<std::string> slowly = {"--points", "8",         "--jobs",  "2",       "--slow",
                                           "100",      "--journal", "journal", "--diary", "diary"};
  ASSERT_TRUE(run_and_kill(slowly, place.here, SIGKILL, milliseconds(260)));
  std::this_thread::sleep_for(milliseconds(300));
  const std::vector<int> before = diary(place);
  ASSERT_LT(before.size(), 8u);
  std::this_thread::sleep_for(milliseconds(300));
  EXPECT_EQ(diary(place), before);
  const std::string journal = place.has("journal") ? place.text("journal") : "";
  // Less the first line; on a slow machine the end came before that.
  const auto kept =
      std::max<std::ptrdiff_t>(0, std::count(journal.begin(), journal.end(), '\n') - 1);
  EXPECT_GE(kept + 2, static_cast<std::ptrdiff_t>(before.size()));  // two were under way
  const Outcome again = place.run(slowly);
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(again.out, squares(8));
  EXPECT_EQ(static_cast<std::ptrdiff_t>(diary(place).size()),
            static_cast<std::ptrdiff_t>(before.size()) + 8 - kept);
}

TEST(Sweep, EndsWithCtrlC) {
  Workplace place;
  place.here.interrupt_after = milliseconds(250);
  const std::vector<std::string> slowly = {"--points", "8",         "--slow",
                                           "100",      "--journal", "journal"};
  const Outcome outcome = place.run(slowly);
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.out.find("number=7 not done\n"), std::string::npos) << outcome.out;
  place.here.interrupt_after.reset();
  EXPECT_EQ(place.run(slowly).out, squares(8));
}

TEST(Sweep, IsRefusedWhereItsProcessesReadSomethingElse) {
  const Workplace place;
  const Outcome outcome = place.run({"--points", "4", "--jobs", "2", "--fickle"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("the inputs have changed"), std::string::npos) << outcome.err;
}

TEST(Sweep, EndsWhereItsProcessesDoNotBegin) {
  const Workplace place;
  EXPECT_EQ(place.run({"--refuses", "2"}).exit_code, 2);
  const Outcome broken = place.run({"--refuses", "70", "--jobs", "2"});
  EXPECT_EQ(broken.exit_code, 70);
  EXPECT_NE(broken.err.find("end before they begin"), std::string::npos) << broken.err;
}

TEST(Sweep, IsRefusedWhereItsJournalIsAnotherFile) {
  const Workplace place;
  place.write("thesis.txt", "words\n");
  const Outcome outcome = place.run({"--journal", "thesis.txt"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(place.text("thesis.txt"), "words\n");
}

}  // namespace
}  // namespace torquewright::cli_test
