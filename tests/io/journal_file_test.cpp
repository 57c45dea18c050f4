// SPDX-License-Identifier: Apache-2.0
// Oracle: the lines that were added, and the bytes of the file.
#include "io/files/journal_file.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "io/faults/spec_error.hpp"
#include "io/files/file_bytes.hpp"
#include "io/files/file_session.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::io {
namespace {

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

std::string refusal(const fs::path& file, std::string_view first_line = "journal") {
  try {
    JournalFile journal(file, first_line);
  } catch (const SpecError& error) {
    return error.what();
  }
  return "";
}

TEST(JournalFile, HoldsWhatWasAdded) {
  const test::ScratchFolder folder;
  const fs::path file = folder.path() / "journal";
  {
    JournalFile journal(file, "journal");
    EXPECT_TRUE(journal.lines().empty());
    journal.add("one");
    journal.add("two");
  }
  EXPECT_EQ(read_file_bytes(file), "journal\none\ntwo\n");
  JournalFile again(file, "journal");
  EXPECT_EQ(again.lines(), (Lines{"one", "two"}));
  again.add("three");
  EXPECT_EQ(read_file_bytes(file), "journal\none\ntwo\nthree\n");
}

TEST(JournalFile, ForgetsALineThatWasHalfWritten) {
  const test::ScratchFolder folder;
  const fs::path file = folder.write("journal", "journal\none\ntw");
  JournalFile journal(file, "journal");
  EXPECT_EQ(journal.lines(), Lines{"one"});
  EXPECT_EQ(read_file_bytes(file), "journal\none\ntw");  // as long as nothing is added
  journal.add("three");
  EXPECT_EQ(read_file_bytes(file), "journal\none\nthree\n");
}

TEST(JournalFile, BeginsAgainWhereItsFirstLineWasHalfWritten) {
  const test::ScratchFolder folder;
  for (const char* half : {"", "jour", "journal"}) {
    const fs::path file = folder.write("journal", half);
    JournalFile journal(file, "journal");
    journal.add("one");
    EXPECT_EQ(read_file_bytes(file), "journal\none\n") << half;
  }
}

TEST(JournalFile, IsNoOtherFile) {
  const test::ScratchFolder folder;
  const fs::path file = folder.write("thesis.txt", "journal of a year\n");
  EXPECT_NE(refusal(file).find("would be lost"), std::string::npos);
  EXPECT_EQ(read_file_bytes(file), "journal of a year\n");
  EXPECT_NE(refusal(folder.path()), "");
  EXPECT_NE(refusal(folder.path() / "no" / "journal"), "");
  EXPECT_NE(refusal("/dev/stdout"), "");
}

TEST(JournalFile, IsNoInput) {
  const test::ScratchFolder folder;
  const fs::path file = folder.write("journal", "journal\n");
  const FileSession session;
  read_file_bytes(file);
  EXPECT_NE(refusal(file).find("it is an input"), std::string::npos);
}

TEST(JournalFile, HasOneWriter) {
  const test::ScratchFolder folder;
  const fs::path file = folder.path() / "journal";
  {
    const JournalFile journal(file, "journal");
    EXPECT_NE(refusal(file).find("another run"), std::string::npos);
  }
  EXPECT_EQ(refusal(file), "");
}

TEST(JournalFile, IsSharedBySeveralWritersAlone) {
  using Writers = JournalFile::Writers;
  const test::ScratchFolder folder;
  const fs::path file = folder.path() / "journal";
  JournalFile first(file, "journal", Writers::kSeveral);
  JournalFile second(file, "journal", Writers::kSeveral);
  EXPECT_NE(refusal(file).find("another run"), std::string::npos);
  first.add("one");
  second.add("two");
  first.add("three");
  EXPECT_EQ(read_file_bytes(file), "journal\none\ntwo\nthree\n");
  first.read_on();
  second.read_on();
  EXPECT_EQ(first.lines(), std::vector<std::string>{"two"}) << "its own are no news";
  EXPECT_EQ(second.lines(), (std::vector<std::string>{"one", "three"}));
}

// What a killed writer had taken is free, and what it had half written is gone.
TEST(JournalFile, NumbersAreTakenByOneAndFreeWithItsEnd) {
  using Writers = JournalFile::Writers;
  const test::ScratchFolder folder;
  const fs::path file = folder.path() / "journal";
  JournalFile first(file, "journal", Writers::kSeveral);
  {
    JournalFile second(file, "journal", Writers::kSeveral);
    EXPECT_TRUE(second.take(7));
    EXPECT_FALSE(first.take(7));
    EXPECT_TRUE(first.take(8));
    second.give_back(7);
    EXPECT_TRUE(first.take(7));
    EXPECT_TRUE(second.take(9));
  }
  EXPECT_TRUE(first.take(9));
  std::ofstream(file, std::ios::app) << "half";
  first.add("whole");
  EXPECT_EQ(read_file_bytes(file), "journal\nwhole\n");
}

// The writer is killed at some moment; whole lines are those of 0, 1, 2, ... without a gap.
TEST(JournalFile, OutlivesItsWriter) {
  const test::ScratchFolder folder;
  const fs::path file = folder.path() / "journal";
  const pid_t writer = ::fork();
  if (writer == 0) {
    JournalFile journal(file, "journal");
    for (int i = 0;; ++i) journal.add(std::to_string(i));
  }
  while (!fs::exists(file) || fs::file_size(file) < 100) ::usleep(100);
  ::kill(writer, SIGKILL);
  ::waitpid(writer, nullptr, 0);
  JournalFile journal(file, "journal");
  ASSERT_FALSE(journal.lines().empty());
  for (std::size_t i = 0; i < journal.lines().size(); ++i) {
    EXPECT_EQ(journal.lines()[i], std::to_string(i));
  }
}

TEST(CheckJournal, MakesNoFile) {
  const test::ScratchFolder folder;
  const fs::path file = folder.path() / "journal";
  check_journal(file, "journal");
  EXPECT_FALSE(fs::exists(file));
  EXPECT_THROW(check_journal(folder.path() / "no" / "journal", "journal"), SpecError);
  EXPECT_THROW(check_journal(folder.write("thesis.txt", "words\n"), "journal"), SpecError);
}

}  // namespace
}  // namespace torquewright::io
