// SPDX-License-Identifier: Apache-2.0
// No command replaces a file that it has read, under whatever name and however it came to read it.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <map>
#include <string>
#include <vector>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using Words = std::vector<std::string>;

/// The examples, with which to work on copies.
struct Examples : Workplace {
  Examples() { fs::copy(in_repository("specs"), path("specs"), fs::copy_options::recursive); }

  /// Every file below it by name, with its text.
  std::map<std::string, std::string> all() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(path())) {
      if (entry.is_regular_file()) files[entry.path().string()] = text_of(entry.path());
    }
    return files;
  }
};

const std::string kKneeFile = "specs/actuator/d151_knee.json";
const std::string kAnkleFile = "specs/actuator/d110a_ankle.json";
const std::string kMotionFile = "specs/trajectory/knee_extension.csv";
const std::string kFlipFile = "specs/trajectory/hopper_flip.csv";
const std::string kHopperFile = "specs/robot/hopper.json";
const std::string kRigFile = "specs/rig/knee_sweep.json";
const std::string kExcitation = "specs/excitation/knee_sweep.csv";

struct Overwrite {
  Words command;
  std::string output;  ///< As it is refused.
};

std::vector<Overwrite> overwrites() {
  const Words check{"actuator", "check", kMotionFile, "--joint", "knee=" + kKneeFile, "-o"};
  const Words simulate{"identify", "simulate",     kKneeFile,   "--rig",
                       kRigFile,   "--excitation", kExcitation, "-o"};
  const Words flip{"hopper", "check", kHopperFile, kFlipFile};
  const auto with = [](Words command, const Words& more) {
    command.insert(command.end(), more.begin(), more.end());
    return command;
  };
  return {
      {{"actuator", "mor", kKneeFile, "-o", kKneeFile}, kKneeFile},
      {{"actuator", "mor", kKneeFile, "--compare", kAnkleFile, "-o", kAnkleFile}, kAnkleFile},
      {with(check, {kKneeFile}), kKneeFile},
      {with(check, {kMotionFile}), kMotionFile},
      {with(simulate, {kExcitation}), kExcitation},
      {with(simulate, {kKneeFile}), kKneeFile},
      {with(simulate, {"specs/../" + kRigFile}), "specs/../" + kRigFile},
      {with(flip, {"-o", kKneeFile}), kKneeFile},
      {with(flip, {"--report", "specs/gearbox/d151_strength.json"}),
       "specs/gearbox/d151_strength.json"},
      {with(flip, {"--candidates", "specs/actuator", "-o", kAnkleFile}), kAnkleFile},
      {{"robot", "export", kHopperFile, "--format", "mjcf", "-o", kKneeFile}, kKneeFile},
      {{"identify", "plan", "specs/log/bench_actuator.json", "--rig", "specs/log/bench_rig.json",
        "-o", "specs/log/bench_rig.json"},
       "specs/log/bench_rig.json"},
  };
}

TEST(FileSession, KeepsWhatItHasRead) {
  const Examples place;
  const auto before = place.all();
  for (const Overwrite& each : overwrites()) {
    const Outcome outcome = place.run(each.command);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.err,
              each.output + ": cannot be written: it is an input, which would be lost\n");
    EXPECT_EQ(place.all(), before) << each.output;
  }
}

TEST(FileSession, KnowsAnInputByAnyName) {
  const Examples place;
  fs::create_hard_link(place.path(kKneeFile), place.path("twin.json"));
  fs::create_symlink(place.path(kKneeFile), place.path("link.json"));
  const auto before = place.all();
  for (const char* name : {"twin.json", "link.json"}) {
    EXPECT_EQ(place.run({"actuator", "mor", kKneeFile, "-o", name}).exit_code, 2);
  }
  EXPECT_EQ(place.all(), before);
}

TEST(FileSession, DoesNotWaitForAPipeThatNobodyFills) {
  const Examples place;
  fs::remove(place.path(kAnkleFile));
  ASSERT_EQ(::mkfifo(place.path(kAnkleFile).c_str(), 0600), 0);
  const Outcome outcome = place.run({"hopper", "check", kHopperFile, kFlipFile});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("is a named pipe, and nobody wrote into it within 5 s"),
            std::string::npos)
      << outcome.err;
}

TEST(Outputs, KeepTheModeOfAFileThatStoodThere) {
  const Examples place;
  const fs::path secret = place.write("secret.csv", "old");
  fs::permissions(secret, fs::perms(0600));
  EXPECT_EQ(place.run({"actuator", "mor", kKneeFile, "-o", "secret.csv"}).exit_code, 0);
  EXPECT_TRUE(place.text("secret.csv").size() > 100);
  EXPECT_EQ(fs::status(secret).permissions(), fs::perms(0600));
}

TEST(Outputs, FollowALinkAndRefuseOneToNothing) {
  const Examples place;
  place.write("real.csv", "old");
  fs::create_symlink("real.csv", place.path("link.csv"));
  EXPECT_EQ(place.run({"actuator", "mor", kKneeFile, "-o", "link.csv"}).exit_code, 0);
  EXPECT_TRUE(fs::is_symlink(place.path("link.csv")));
  EXPECT_TRUE(place.text("real.csv").size() > 100);

  fs::create_symlink("absent.csv", place.path("nowhere.csv"));
  const Outcome outcome = place.run({"actuator", "mor", kKneeFile, "-o", "nowhere.csv"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err,
            "nowhere.csv: cannot be written: it is a link to a file that does not exist\n");
}

void remove_temporary_files(const Workplace& place) {
  for (const auto& [name, text] : place.files()) {
    if (name.ends_with(".tmp")) fs::remove(place.path(name));
  }
}

// Fifteen moments from the start to past the end, four signals. Each file is whole, and those that
// belong together are of one run, and nothing else is left, unless nothing could hold the signal
// back (KILL).
TEST(Outputs, AreOldOrNewAfterAnySignal) {
  const Examples place;
  const Words command{"actuator", "mor",   kKneeFile, "--at-speed", "0,1",
                      "-o",       "x.csv", "--plot",  "y.svg"};
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(place.run(command).exit_code, 0);
  const auto whole_run = std::chrono::duration_cast<std::chrono::microseconds>(
      std::chrono::steady_clock::now() - start);
  const std::string rows = place.text("x.csv"), picture = place.text("y.svg");
  constexpr int kMoments = 15;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGKILL}) {
    for (int i = 0; i < kMoments; ++i) {
      place.write("x.csv", "old");
      place.write("y.svg", "old");
      run_and_kill(command, place.here, signal, whole_run * i / (kMoments - 2));
      const std::string x = place.text("x.csv"), y = place.text("y.svg");
      EXPECT_TRUE(x == "old" || x == rows);
      EXPECT_TRUE(y == "old" || y == picture);
      EXPECT_TRUE(signal == SIGKILL || (x == "old") == (y == "old"));
      const bool has_left_nothing = place.files().size() == 3;
      EXPECT_TRUE(signal == SIGKILL || has_left_nothing)
          << "a temporary file is left by " << signal;
      if (!has_left_nothing) remove_temporary_files(place);
    }
  }
}

const Words kMor{"actuator", "mor", kKneeFile, "--at-speed", "0,1"};

Words mor_to(const std::string& output) {
  Words command = kMor;
  command.insert(command.end(), {"-o", output});
  return command;
}

// Oracle: what the file of a plain `-o` holds.
TEST(Outputs, GoIntoAPipe) {
  const Examples place;
  ASSERT_EQ(place.run(mor_to("x.csv")).exit_code, 0);
  fs::create_symlink("/dev/stdout", place.path("link"));
  fs::create_symlink("link", place.path("longer_link"));
  for (const char* name : {"/dev/stdout", "/dev/fd/1", "/proc/self/fd/1", "/proc/thread-self/fd/1",
                           "link", "longer_link"}) {
    const Outcome outcome = place.run(mor_to(name));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find(place.text("x.csv")), std::string::npos) << name;
  }
}

TEST(Outputs, AreAppendedWhereTheShellAppends) {
  Examples place;
  place.here.stdout_file = place.write("log", "earlier\n");
  ASSERT_EQ(place.run(mor_to("x.csv")).exit_code, 0);
  place.write("log", "earlier\n");
  EXPECT_EQ(place.run(mor_to("/dev/stdout")).exit_code, 0);
  EXPECT_TRUE(place.text("log").starts_with("earlier\n"));
  EXPECT_NE(place.text("log").find(place.text("x.csv")), std::string::npos);
}

TEST(Outputs, DoNotGoIntoAnInputBehindStandardOutput) {
  Examples place;
  place.here.stdout_file = place.path(kKneeFile);
  const auto before = place.all();
  for (const std::vector<std::string>& command :
       {mor_to("-"), {"actuator", "mor", kKneeFile, "--at-speed", "0"}, mor_to("/dev/stdout")}) {
    EXPECT_EQ(place.run(command).exit_code, 2);
    EXPECT_EQ(place.all(), before);
  }
}

TEST(Outputs, AreRefusedIntoADescriptorThatIsNotOpen) {
  const Outcome outcome = Examples().run(mor_to("/dev/fd/777"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err, "/dev/fd/777: cannot be written: no such descriptor is open\n");
}

TEST(Outputs, DoNotWaitForAReaderAgainstASignal) {
  const Examples place;
  ASSERT_EQ(::mkfifo(place.path("pipe").c_str(), 0600), 0);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    EXPECT_TRUE(run_and_kill(mor_to("pipe"), place.here, signal, std::chrono::seconds(1)));
  }
}

TEST(Outputs, AreRefusedUnderNoName) {
  const Examples place;
  EXPECT_EQ(place.run({"actuator", "mor", kKneeFile, "-o", ""}).exit_code, 2);
  EXPECT_EQ(
      place.run({"actuator", "check", kMotionFile, "--joint", "knee=" + kKneeFile, "--plot", ""})
          .exit_code,
      2);
}

}  // namespace
}  // namespace torquewright::cli_test
