// SPDX-License-Identifier: Apache-2.0
// Sweeps under mpirun, where it is installed. Oracle: the same sweep without it.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

/// Another program in place of toy_sweep, or variables of the environment, as long as it lives.
class Surroundings {
 public:
  explicit Surroundings(const char* variable, const std::string& value) : variable_(variable) {
    ::setenv(variable, value.c_str(), 1);
  }
  ~Surroundings() { ::unsetenv(variable_); }
  Surroundings(const Surroundings&) = delete;
  Surroundings& operator=(const Surroundings&) = delete;

 private:
  const char* variable_;
};

Outcome by_ranks(const Workplace& place, const char* ranks, std::vector<std::string> toy,
                 const std::vector<std::string>& options = {}) {
  const Surroundings mpirun("TORQUEWRIGHT_STAND_IN", TORQUEWRIGHT_MPIRUN);
  std::vector<std::string> words = {"--allow-run-as-root", "--oversubscribe", "-n", ranks};
  words.insert(words.end(), options.begin(), options.end());
  words.emplace_back(TORQUEWRIGHT_PROGRAM);
  words.insert(words.end(), toy.begin(), toy.end());
  return run(words, place.here);
}

class Ranks : public testing::Test {
 protected:
  void SetUp() override {
    if (std::string(TORQUEWRIGHT_MPIRUN).empty()) {
      GTEST_SKIP() << "openmpi-bin is not installed";
    }
  }
};

TEST_F(Ranks, SayTheSameInAnyNumber) {
  const Workplace place;
  const std::string alone = place.run({"--points", "9"}).out;
  for (const char* ranks : {"1", "2", "4"}) {
    const std::string diary = std::string("diary_of_") + ranks;
    const Outcome outcome = by_ranks(
        place, ranks,
        {"--points", "9", "--journal", std::string("journal_of_") + ranks, "--diary", diary});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, alone) << ranks;
    EXPECT_EQ(place.text(diary).size(), 18u) << "a point was done twice";
  }
}

TEST_F(Ranks, LoseThePointOfAProcessThatIsKilled) {
  const Workplace place;
  const Outcome outcome =
      by_ranks(place, "3", {"--points", "6", "--killed", "3", "--journal", "journal"});
  EXPECT_NE(outcome.out.find("number=3 lost: its process was ended by signal 9"), std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find(R"(number=5 {"square":25)"), std::string::npos) << outcome.out;
  // On one machine it goes on with what ranks have done, and finds the one that is lost.
  const Outcome again = place.run({"--points", "6", "--journal", "journal", "--diary", "diary"});
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_EQ(place.text("diary"), "3\n");
}

// mpirun as it is ends all ranks with the one that was killed; what they had done is kept.
TEST_F(Ranks, GoOnAfterAllWereEnded) {
  const Workplace place;
  by_ranks(place, "3", {"--points", "8", "--slow", "300", "--journal", "journal", "--dies", "2"});
  const Outcome again = place.run({"--points", "8", "--journal", "journal"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(again.out, place.run({"--points", "8"}).out);
}

// With --enable-recovery the others go on.
TEST_F(Ranks, LoseOnePointWithOneOfThem) {
  const Workplace place;
  const Outcome outcome = by_ranks(
      place, "3", {"--points", "8", "--slow", "300", "--journal", "journal", "--dies", "2"},
      {"--enable-recovery"});
  std::size_t lost = 0;
  for (std::size_t at = outcome.out.find("lost: its rank"); at != std::string::npos;
       at = outcome.out.find("lost: its rank", at + 1)) {
    ++lost;
  }
  EXPECT_EQ(lost, 1u) << outcome.out << outcome.err;
  EXPECT_EQ(outcome.out.find("not done"), std::string::npos) << outcome.out;
  const Outcome again = place.run({"--points", "8", "--journal", "journal", "--diary", "diary"});
  EXPECT_EQ(again.out, place.run({"--points", "8"}).out);
  EXPECT_EQ(place.text("diary").size(), 2u) << "more than one point was lost";
}

TEST_F(Ranks, AreRefusedWhereInputsChange) {
  const Workplace place;
  const Outcome outcome =
      by_ranks(place, "3", {"--points", "4", "--fickle", "--journal", "journal"});
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_NE(outcome.err.find("the inputs have changed"), std::string::npos) << outcome.err;
}

// A rank that nobody hands points to would wait for ever.
TEST(RankOfTheEnvironment, IsRefusedWhereItIsNoneOfThem) {
  const Workplace place;
  const Surroundings rank("OMPI_COMM_WORLD_RANK", "3");
  const Outcome outcome = place.run({"--points", "2"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("OMPI_COMM_WORLD_RANK: 3 is not one of the 1 ranks"),
            std::string::npos)
      << outcome.err;
}

// Ranks of which each has a file of its own would do everything.
TEST(RanksOfTheEnvironment, AreRefusedWithoutAJournalToShare) {
  const Workplace place;
  const Surroundings size("OMPI_COMM_WORLD_SIZE", "2");
  const Outcome outcome = place.run({"--points", "2"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("its ranks share a journal"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace torquewright::cli_test
