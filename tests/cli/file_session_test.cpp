// SPDX-License-Identifier: Apache-2.0
// No command replaces a file that it has read, under whatever name and however it came to read it.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <functional>
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
const std::string kHopFile = "specs/trajectory/hopper_hop.csv";
const std::string kDrawsFile = "specs/randomisation/hopper.json";
const std::string kResultFile = "specs/gearbox/d151_knee_result.json";
const std::string kStrengthFile = "specs/gearbox/d151_strength.json";
const std::string kProblemFile = "specs/gearbox/d151_knee.json";
const std::string kSquatFile = "specs/trajectory/hopper_squat.csv";
const std::string kBenchLog = "specs/log/bench_as_built.csv";
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
  const Words calibrate{"hopper",      "calibrate", kHopperFile,
                        "--target",    "cam=6",     "--target",
                        "cav@tuck=10", "--free",    "/bodies/0/inertia_kg_m2/yy=0.05:0.45"};
  const Words replay{"hopper",   "replay", kHopperFile,   "specs/trajectory/hopper_squat.csv",
                     "--trials", "1",      "--randomise", kDrawsFile};
  const Words identify{"identify",   kBenchLog,
                       "--rig",      "specs/log/bench_rig.json",
                       "--actuator", "specs/log/bench_actuator.json"};
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
      {{"actuator", "mor", kKneeFile, "--format", "mujoco", "--export", kKneeFile}, kKneeFile},
      {{"actuator", "lint", kAnkleFile, kKneeFile, "-o", kKneeFile}, kKneeFile},
      {with(calibrate, {"--refined", kHopperFile}), kHopperFile},
      {with(calibrate, {"--refined", kKneeFile}), kKneeFile},
      {with(replay, {"--series", kDrawsFile}), kDrawsFile},
      {with(replay, {"-o", kDrawsFile}), kDrawsFile},
      {with(replay, {"--report", kAnkleFile}), kAnkleFile},
      {{"hopper", "flip", kHopperFile, "-o", "plan.csv", "--warm", kHopFile, "--report", kHopFile},
       kHopFile},
      {with(identify, {"--refined", kBenchLog}), kBenchLog},
      {with(identify, {"-o", "specs/log/bench_actuator.json", "--refined", "r.json"}),
       "specs/log/bench_actuator.json"},
      {with(identify, {"--report", "specs/log/bench_rig.json"}), "specs/log/bench_rig.json"},
      {{"robot", "import", "specs/robot/rabbit.urdf", "-o", "specs/robot/rabbit.urdf"},
       "specs/robot/rabbit.urdf"},
      {{"gearbox", "verify", kResultFile, "-o", kResultFile}, kResultFile},
      {{"gearbox", "strength", kResultFile, "--torque", "16", "--steel", "case_hardened",
        "--face-width", "10", "-o", kResultFile},
       kResultFile},
      // Hopper, strength, result, problem: named by what is read, or by what that names.
      {{"gearbox", "strength", kStrengthFile, "--torque", "21", "-o", kProblemFile}, kProblemFile},
      {{"gearbox", "strength", kResultFile, "--torque", "16", "--steel", "case_hardened",
        "--face-width", "10", "-o", kProblemFile},
       kProblemFile},
      {{"hopper", "check", kHopperFile, kSquatFile, "-o", kProblemFile}, kProblemFile},
      {{"hopper", "check", kHopperFile, kSquatFile, "--sweep", "mass_factor=1:1.2:0.1", "-o",
        kProblemFile},
       kProblemFile},
      {with(flip, {"--candidates", "specs/actuator", "-o", kProblemFile}), kProblemFile},
      {with(replay, {"-o", kProblemFile}), kProblemFile},
      {{"hopper", "flip", kHopperFile, "-o", "plan.csv", "--report", kProblemFile}, kProblemFile},
      {{"robot", "export", kHopperFile, "--format", "mjcf", "-o", kProblemFile}, kProblemFile},
      {{"robot", "export", kHopperFile, "--format", "mjcf", "-o", kResultFile}, kResultFile},
      {{"actuator", "mor", "specs/log/bench_refined.json", "-o", kBenchLog}, kBenchLog},
      {{"identify", "import", "moteus", "imported/log.csv", "-o", "imported"}, "imported/log.csv"},
  };
}

TEST(FileSession, KeepsWhatItHasRead) {
  const Examples place;
  fs::create_directory(place.path("imported"));
  place.write("imported/log.csv", place.text("specs/log/wheel_moteus.csv"));
  const auto before = place.all();
  for (const Overwrite& each : overwrites()) {
    SCOPED_TRACE(each.command[0] + " " + each.command[1] + " onto " + each.output);
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

// Names that lead in a circle, to nothing, or to a folder keep nothing from being written.
TEST(FileSession, FollowsNamesThatLeadInACircle) {
  const Examples place;
  place.write("back.json", R"({"file": "round.json", "actuators": ["none.json", "specs"]})");
  place.write("round.json", R"({"path": "back.json", "strength": "last.csv"})");
  place.write("last.csv", "1,2\n");
  std::string result = place.text(kResultFile);
  const std::size_t name = result.find(kProblemFile);
  ASSERT_NE(name, std::string::npos);
  result.replace(name, kProblemFile.size(), "round.json");
  place.write("result.json", result);
  const Words strength{"gearbox", "strength",      "result.json",  "--torque", "16",
                       "--steel", "case_hardened", "--face-width", "10",       "-o"};
  const auto onto = [&](const std::string& output) {
    Words command = strength;
    command.push_back(output);
    return place.run(command).exit_code;
  };
  for (const char* kept : {"round.json", "back.json", "last.csv"}) {
    EXPECT_EQ(onto(kept), 2) << kept;
  }
  EXPECT_NE(onto(kProblemFile), 2);  // which that result does not name
}

/// Exit code of a line for the shell, in which $T is the program.
int shell(const Workplace& place, const std::string& line) {
  const std::string words =
      "cd '" + place.path().string() + "' && T='" TORQUEWRIGHT_PROGRAM "' && " + line;
  const int status = std::system(words.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// What came through a pipe cannot be read a second time.
TEST(FileSession, FollowsNamesInAPipe) {
  const Examples place;
  const auto before = place.all();
  EXPECT_EQ(shell(place, "cat " + kResultFile +
                             " | $T gearbox strength /dev/stdin --torque 16 --steel case_hardened"
                             " --face-width 10 -o " +
                             kProblemFile + " 2> /dev/null"),
            2);
  EXPECT_EQ(place.all(), before);
}

// Replaced, the file would no longer be the one that the stream leads into.
TEST(Outputs, AreNotWhatAStreamLeadsInto) {
  const Examples place;
  const std::string mor = "$T actuator mor " + kKneeFile + " --at-speed 0 ";
  for (const char* stream : {"> q.json", ">> q.json"}) {
    place.write("q.json", "");
    EXPECT_EQ(shell(place, mor + "-o q.json " + stream + " 2> said"), 2) << stream;
    EXPECT_EQ(place.text("said"),
              "q.json: cannot be written: it is what standard output leads into, which would be "
              "lost\n");
    EXPECT_EQ(place.text("q.json"), "");
  }
  EXPECT_EQ(shell(place, mor + "-o q.json > /dev/null 2> q.json"), 2);
  EXPECT_NE(place.text("q.json").find("what standard error leads into"), std::string::npos);
  EXPECT_EQ(shell(place, mor + "-o /dev/stdout > q.json 2> said"), 0);
}

TEST(Outputs, DoNotGoIntoAnInputBehindStandardError) {
  const Examples place;
  const auto before = place.all();
  for (const std::string& line : {
           "$T actuator mor " + kKneeFile + " --at-speed 0 2>> " + kKneeFile,
           "$T actuator mor " + kKneeFile + " --at-speed 0 >> " + kKneeFile + " 2>&1",
           "$T robot export " + kHopperFile + " --format mjcf 2>> " + kResultFile,
       }) {
    EXPECT_EQ(shell(place, "( " + line + " ) > out"), 2) << line;
    fs::remove(place.path("out"));
    EXPECT_EQ(place.all(), before) << line;
  }
  EXPECT_EQ(shell(place, "$T actuator mor " + kKneeFile + " 2>> " + kKneeFile + " > said"), 2);
  EXPECT_EQ(place.text("said"), "standard error: leads into an input, which would be lost\n");
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

TEST(Outputs, KeepTheOwnerOfAFileThatStoodThere) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root gives files away";
  const Examples place;
  const fs::path given = place.write("given.csv", "old");
  ASSERT_EQ(::chown(given.c_str(), 1234, 4321), 0);
  EXPECT_EQ(place.run({"actuator", "mor", kKneeFile, "-o", "given.csv"}).exit_code, 0);
  struct stat status {};
  ASSERT_EQ(::stat(given.c_str(), &status), 0);
  EXPECT_GT(status.st_size, 100);
  EXPECT_EQ(status.st_uid, 1234u);
  EXPECT_EQ(status.st_gid, 4321u);
}

TEST(Outputs, GoIntoADeviceThatStaysOne) {
  const Examples place;
  EXPECT_EQ(place.run({"actuator", "mor", kKneeFile, "-o", "/dev/null"}).exit_code, 0);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  const Outcome full = place.run({"actuator", "mor", kKneeFile, "-o", "/dev/full"});
  EXPECT_EQ(full.exit_code, 2);
  EXPECT_EQ(full.err, "/dev/full: cannot be written: No space left on device\n");
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

/// A command that writes these, and may be stopped in the middle.
struct Stopped {
  Words command;
  std::vector<std::string> outputs;
  int moments = 7;
};

const std::vector<Stopped> kStopped{
    {{"actuator", "mor", kKneeFile, "--at-speed", "0,1", "-o", "x.csv", "--plot", "y.svg"},
     {"x.csv", "y.svg"},
     15},
    {{"hopper", "check", kHopperFile, "specs/trajectory/hopper_squat.csv", "--report", "x.html",
      "--series", "y.csv"},
     {"x.html", "y.csv"}},
    {{"identify", kBenchLog, "--rig", "specs/log/bench_rig.json", "--actuator",
      "specs/log/bench_actuator.json", "--report", "x.html", "--refined", "y.json", "-o", "z.json"},
     {"x.html", "y.json", "z.json"}},
    {{"robot", "export", kHopperFile, "--format", "mjcf", "--actuators", "-o", "x.xml"},
     {"x.xml"}}};

/// Which of the outputs are new; each is old or as a run that was left alone wrote it.
std::vector<bool> new_outputs(const Workplace& place, const Stopped& stopped,
                              const std::vector<std::string>& whole) {
  std::vector<bool> are_new;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const std::string text = place.text(stopped.outputs[i]);
    EXPECT_TRUE(text == "old" || text == whole[i]) << stopped.outputs[i];
    are_new.push_back(text != "old");
  }
  return are_new;
}

void remove_what_is_left(const Workplace& place, const std::string& folder) {
  for (const auto& entry : fs::directory_iterator(place.path(folder))) {
    if (folder.empty() ? entry.path().extension() == ".tmp" : true) fs::remove_all(entry.path());
  }
}

void expect_old_or_new(const Stopped& stopped, const std::vector<int>& signals) {
  SCOPED_TRACE(stopped.command[0] + " " + stopped.command[1]);
  Examples place;
  fs::create_directory(place.path("temporary"));
  place.here.environment.push_back("TMPDIR=" + place.path("temporary").string());
  const auto start = std::chrono::steady_clock::now();
  ASSERT_NE(place.run(stopped.command).exit_code, 2);
  const auto whole_run = std::chrono::duration_cast<std::chrono::microseconds>(
      std::chrono::steady_clock::now() - start);
  std::vector<std::string> whole;
  for (const std::string& output : stopped.outputs) whole.push_back(place.text(output));
  const std::size_t files = place.files().size();
  for (const int signal : signals) {
    for (int i = 0; i < stopped.moments; ++i) {
      for (const std::string& output : stopped.outputs) place.write(output, "old");
      EXPECT_TRUE(
          run_and_kill(stopped.command, place.here, signal, whole_run * i / (stopped.moments - 2)));
      const std::vector<bool> are_new = new_outputs(place, stopped, whole);
      if (signal != SIGKILL) {  // which nothing could hold back
        EXPECT_EQ(std::adjacent_find(are_new.begin(), are_new.end(), std::not_equal_to<>()),
                  are_new.end());
        EXPECT_EQ(place.files().size(), files) << "a file is left by " << signal;
        EXPECT_TRUE(fs::is_empty(place.path("temporary"))) << signal;
      }
      remove_what_is_left(place, "");
      remove_what_is_left(place, "temporary");
    }
  }
}

// Moments from the start to past the end, four signals. Each file is whole, those that
// belong together are of one run, and nothing else is left, here or where temporary files go.
TEST(Outputs, AreOldOrNewAfterAnySignal) {
  for (const Stopped& stopped : kStopped) {
    expect_old_or_new(stopped, {SIGINT, SIGTERM, SIGHUP, SIGKILL});
  }
}

// Whatever else ends a program that does not listen: terminals, timers, limits, other programs.
TEST(Outputs, AreOldOrNewAfterRareSignals) {
  const rlimit no_core{0, 0};
  ASSERT_EQ(::setrlimit(RLIMIT_CORE, &no_core), 0);  // some would leave one
  expect_old_or_new(kStopped[0], {SIGQUIT, SIGALRM, SIGUSR1, SIGUSR2, SIGXCPU, SIGVTALRM});
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
  for (const char* name :
       {"/dev/stdout", "/dev/fd/1", "/proc/self/fd/1", "/proc/thread-self/fd/1"}) {
    const Outcome outcome = place.run(mor_to(name));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find(place.text("x.csv")), std::string::npos) << name;
  }
}

TEST(Outputs, AreAppendedWhereTheShellAppends) {
  Examples place;
  place.here.stdout_file = place.write("log", "earlier\n");
  ASSERT_EQ(place.run(mor_to("x.csv")).exit_code, 0);
  fs::create_symlink("/dev/stdout", place.path("link"));
  fs::create_symlink("link", place.path("longer_link"));
  for (const char* name : {"/dev/stdout", "link", "longer_link"}) {
    place.write("log", "earlier\n");
    EXPECT_EQ(place.run(mor_to(name)).exit_code, 0);
    EXPECT_TRUE(place.text("log").starts_with("earlier\n")) << name;
    EXPECT_NE(place.text("log").find(place.text("x.csv")), std::string::npos) << name;
  }
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

TEST(Outputs, ArePagesUnderNoOtherEnding) {
  const Examples place;
  for (const char* name : {"notes.json", "notes.csv", "notes.svg"}) {
    const Outcome outcome =
        place.run({"hopper", "check", kHopperFile, kSquatFile, "--report", name});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.err,
              "--report: \"" + std::string(name) + "\" becomes a page, and must end with .html\n");
    EXPECT_FALSE(place.has(name));
  }
  EXPECT_EQ(place.run({"hopper", "check", kHopperFile, kSquatFile, "--report", "page"}).exit_code,
            0);
}

// Else the second identical run would read it, and refuse to replace it.
TEST(Outputs, DoNotBecomeCandidates) {
  const Examples place;
  const Words check{"hopper", "check", kHopperFile, kSquatFile, "--candidates", "specs/actuator"};
  for (const char* name : {"specs/actuator/x.json", "specs/robot/../actuator/x.json"}) {
    Words command = check;
    command.insert(command.end(), {"-o", name});
    const Outcome outcome = place.run(command);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("one of the candidates of the next run"), std::string::npos)
        << outcome.err;
    EXPECT_FALSE(place.has("specs/actuator/x.json"));
  }
}

TEST(Sweeps, OfMassesBeyondAllNumbersAreRefused) {
  const Outcome outcome =
      Examples().run({"hopper", "check", kHopperFile, kSquatFile, "--sweep", "mass_factor=1e308"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err.find("inf"), std::string::npos) << outcome.err;
}

// The variable by which a sweep knows its own processes, set by somebody else.
TEST(Sweeps, SayWhereNoSweepHasStartedThem) {
  Examples place;
  place.here.environment = {"TORQUEWRIGHT_SWEEP_WORKER=1"};
  const Outcome outcome =
      place.run({"hopper", "check", kHopperFile, kSquatFile, "--sweep", "mass_factor=1:1.2:0.1"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(outcome.err.starts_with("TORQUEWRIGHT_SWEEP_WORKER: is set")) << outcome.err;
}

TEST(Outputs, AreRefusedUnderNoName) {
  const Examples place;
  EXPECT_EQ(place.run({"actuator", "mor", kKneeFile, "-o", ""}).exit_code, 2);
  EXPECT_EQ(
      place.run({"actuator", "check", kMotionFile, "--joint", "knee=" + kKneeFile, "--plot", ""})
          .exit_code,
      2);
}

// What the starter closed is not taken by a file that is opened.
TEST(FileSession, MistakesNoFileForAClosedStandardError) {
  Workplace place;
  place.here.closes_stderr = true;
  const Outcome outcome =
      place.run({"actuator", "mor", in_repository(kKneeFile), "--at-speed", "0"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.out.find("0,-320"), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace torquewright::cli_test
