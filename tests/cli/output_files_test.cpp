// SPDX-License-Identifier: Apache-2.0
// Files are written whole or not at all, all of them or none; what cannot be written is refused
// before the work.
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

struct KneePlace : Workplace {
  KneePlace() {
    write("knee.json", knee());
    write("result.json", "old");
  }
};

/// Expects that the knee is refused with these outputs, and no file has changed.
void expect_refused_outputs(const Workplace& place, const std::vector<std::string>& outputs,
                            const std::string& refusal) {
  const auto before = place.files();
  for (std::vector<std::string> command :
       {std::vector<std::string>{"gearbox", "optimize", "knee.json"},
        std::vector<std::string>{"gearbox", "evaluate", "knee.json", "--teeth", "44,44,32"}}) {
    command.insert(command.end(), outputs.begin(), outputs.end());
    const Outcome outcome = place.run(command);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, refusal);
    EXPECT_EQ(place.files(), before);
  }
}

TEST(OutputFiles, NeedAFolder) {
  expect_refused_outputs(KneePlace(), {"-o", "result.json", "--draw", "absent/x.svg"},
                         "absent/x.svg: cannot be written: its folder does not exist\n");
  expect_refused_outputs(KneePlace(), {"-o", "absent/x.json", "--draw", "x.svg"},
                         "absent/x.json: cannot be written: its folder does not exist\n");
}

TEST(OutputFiles, AreRefusedEachInItsLine) {
  expect_refused_outputs(KneePlace(), {"-o", "absent/x.json", "--draw", "knee.json/x.svg"},
                         "absent/x.json: cannot be written: its folder does not exist\n"
                         "knee.json/x.svg: cannot be written: its folder is a file\n");
}

TEST(OutputFiles, AreNoFolders) {
  const KneePlace place;
  fs::create_directory(place.path("folder"));
  expect_refused_outputs(place, {"--draw", "folder", "-o", "result.json"},
                         "folder: cannot be written: it is a folder\n");
  expect_refused_outputs(place, {"--draw", "folder/", "-o", "result.json"},
                         "folder/: cannot be written: a file's name is missing\n");
}

TEST(OutputFiles, HaveNamesThatTheSystemTakes) {
  const std::string longest(255, 'x'), longer = longest + 'x';
  expect_refused_outputs(KneePlace(), {"-o", longer},
                         longer + ": cannot be written: File name too long\n");
  EXPECT_EQ(KneePlace().run({"gearbox", "optimize", "knee.json", "-o", longest}).exit_code, 0);
}

TEST(OutputFiles, AreNoLinksToThemselves) {
  const KneePlace place;
  fs::create_symlink("loop.json", place.path("loop.json"));
  const Outcome outcome = place.run({"init", "actuator", "-o", "loop.json"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err,
            "loop.json: cannot be written: it is a link to a file that does not exist\n");
}

TEST(OutputFiles, AreNotTheInput) {
  const KneePlace place;
  fs::create_symlink("knee.json", place.path("link.json"));
  fs::create_hard_link(place.path("knee.json"), place.path("twin.json"));
  const std::string why = ": cannot be written: it is an input, which would be lost\n";
  expect_refused_outputs(place, {"-o", "knee.json"}, "knee.json" + why);
  expect_refused_outputs(place, {"-o", "./knee.json"}, "./knee.json" + why);
  expect_refused_outputs(place, {"--draw", "link.json"}, "link.json" + why);
  expect_refused_outputs(place, {"--draw", "twin.json"}, "twin.json" + why);
}

TEST(OutputFiles, AreTwoFiles) {
  const std::string why = ": cannot be written: it is named for two outputs\n";
  expect_refused_outputs(KneePlace(), {"-o", "x", "--draw", "./x"}, "./x" + why);
  expect_refused_outputs(KneePlace(), {"-o", "./result.json", "--draw", "result.json"},
                         "result.json" + why);
}

TEST(OutputFiles, DoNotGoIntoAReadOnlyFolder) {
  KneePlace place;
  place.here.as_nobody = ::geteuid() == 0;  // root may write everywhere
  fs::permissions(place.path(), fs::perms(0755));
  if (place.run({"--version"}).exit_code == kNotStarted) {
    GTEST_SKIP() << "root's rights bind nothing, and without them the program cannot be started "
                    "from where it was built";
  }
  fs::create_directory(place.path("fixed"));
  fs::permissions(place.path("fixed"), fs::perms(0555));
  expect_refused_outputs(place, {"-o", "fixed/x.json"},
                         "fixed/x.json: cannot be written: Permission denied\n");
}

// The result fits, the drawing (a quarter of a megabyte) does not.
TEST(OutputFiles, AreAllWrittenOrNone) {
  KneePlace place;
  place.here.file_size_limit = 100'000;
  expect_refused_outputs(place, {"-o", "result.json", "--draw", "x.svg"},
                         "x.svg: cannot be written: File too large\n");
}

TEST(OutputFiles, AreNotHalfWrittenOnAFullDisk) {
  KneePlace place;
  place.here.file_size_limit = 1000;
  expect_refused_outputs(place, {"-o", "result.json"},
                         "result.json: cannot be written: File too large\n");
  expect_refused_outputs(place, {"--draw", "x.svg"}, "x.svg: cannot be written: File too large\n");
}

TEST(OutputFiles, AreWrittenWhereNothingHinders) {
  const KneePlace place;
  EXPECT_EQ(place.run({"gearbox", "optimize", "knee.json", "-o", "result.json", "--draw", "x.svg"})
                .exit_code,
            0);
  EXPECT_TRUE(place.text("result.json").ends_with("}\n"));
  EXPECT_TRUE(place.text("x.svg").starts_with("<"));
  EXPECT_TRUE(place.text("x.svg").ends_with("</svg>\n"));
  EXPECT_EQ(place.files().size(), 3u);  // no temporary files
}

// Decided: exit 1 as without --draw, the result is written, the drawing's file stays as it is.
TEST(OutputFiles, LackADrawingWhereThereIsNoDesign) {
  const Workplace place;
  place.write("tight.json", tight_knee());
  place.write("old.svg", "old");
  for (const std::string drawing : {"old.svg", "new.svg"}) {
    const Outcome outcome =
        place.run({"gearbox", "optimize", "tight.json", "--draw", drawing, "-o", "result.json"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.err, drawing + ": not written, there is no design to draw\n");
    EXPECT_TRUE(place.has("result.json"));
  }
  EXPECT_EQ(place.text("old.svg"), "old");
  EXPECT_FALSE(place.has("new.svg"));
}

TEST(StandardOutput, IsNotCutOffUnseen) {
  KneePlace place;
  place.here.stdout_file = place.path("out.txt");
  place.here.file_size_limit = 1000;
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"gearbox", "optimize", "knee.json"}, {"actuator", "mor", "--help"}, {"man", "init"}}) {
    const Outcome outcome = place.run(words);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.err, "standard output: cannot be written: File too large\n");
  }
}

}  // namespace
}  // namespace torquewright::cli_test
