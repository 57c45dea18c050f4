// SPDX-License-Identifier: Apache-2.0
// Named pipes in the place of files, to every command: nobody writes into them, nobody reads from
// them. No command waits for that without end, or ends without a word.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using Words = std::vector<std::string>;

const std::string kWholeKnee = in_repository("specs/actuator/d151_knee.json").string();
const std::string kWholeRobot = in_repository("specs/robot/hopper.json").string();
const std::string kWholeSquat = in_repository("specs/trajectory/hopper_squat.csv").string();
const std::string kWholeRig = in_repository("specs/rig/knee_sweep.json").string();

/// They wait at the same time.
std::vector<Outcome> run_all(const Workplace& place, const std::vector<Words>& commands) {
  std::vector<Outcome> outcomes(commands.size());
  std::vector<std::jthread> runs;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    runs.emplace_back([&, i] { outcomes[i] = place.run(commands[i]); });
  }
  runs.clear();
  return outcomes;
}

void expect_refused(const std::vector<Words>& commands, const std::string& why) {
  const Workplace place;
  for (const char* pipe : {"pipe", "pipe.svg", "pipe.urdf"}) {
    ASSERT_EQ(::mkfifo(place.path(pipe).c_str(), 0600), 0);
  }
  const std::vector<Outcome> outcomes = run_all(place, commands);
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const std::string what = commands[i][0] + " " + commands[i][1] + ": " + outcomes[i].err;
    EXPECT_EQ(outcomes[i].exit_code, 2) << what;
    EXPECT_NE(outcomes[i].err.find(why), std::string::npos) << what;
    EXPECT_EQ(outcomes[i].out, "") << what;
  }
  EXPECT_EQ(place.files().size(), 3u);
}

TEST(NastyPipes, ThatNobodyWritesInto) {
  expect_refused(
      {
          {"gearbox", "optimize", "pipe"},
          {"gearbox", "evaluate", "pipe", "--teeth", "44,44,32"},
          {"gearbox", "verify", "pipe"},
          {"gearbox", "strength", "pipe", "--torque", "21"},
          {"actuator", "mor", "pipe"},
          {"actuator", "mor", kWholeKnee, "--compare", "pipe"},
          {"actuator", "lint", "pipe"},
          {"actuator", "check", "pipe", "--joint", "knee=" + kWholeKnee},
          {"actuator", "check", kWholeSquat, "--joint", "knee=pipe"},
          {"hopper", "check", "pipe", kWholeSquat},
          {"hopper", "check", kWholeRobot, "pipe"},
          {"hopper", "check", kWholeRobot, "pipe", "--sweep", "mass=12,14"},
          {"hopper", "flip", "pipe", "-o", "plan.csv"},
          {"hopper", "flip", kWholeRobot, "-o", "plan.csv", "--warm", "pipe"},
          {"hopper", "replay", "pipe", kWholeSquat},
          {"hopper", "replay", kWholeRobot, kWholeSquat, "--trials", "1", "--randomise", "pipe"},
          {"hopper", "calibrate", "pipe", "--target", "cam=6", "--free",
           "/bodies/0/inertia_kg_m2/yy"},
          {"identify", "pipe", "--rig", kWholeRig, "--actuator", kWholeKnee},
          {"identify", "plan", "pipe", "--rig", kWholeRig},
          {"robot", "import", "pipe.urdf"},
          {"robot", "export", "pipe", "--format", "urdf"},
      },
      "is a named pipe, and nobody wrote into it within 5 s");
}

// Oracle: the ranking without it.
// A terminal at which nobody types.
TEST(NastyPipes, AndDevicesThatGiveNothing) {
  const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (terminal < 0 || ::grantpt(terminal) != 0 || ::unlockpt(terminal) != 0) {
    GTEST_SKIP() << "needs a system with pseudo-terminals";
  }
  const std::string name = ::ptsname(terminal);
  const int held = ::open(name.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  const Outcome outcome = Workplace().run({"actuator", "mor", name});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err, name + ": is a device, and nobody wrote into it within 5 s\n");
  ::close(held);
  ::close(terminal);
}

TEST(NastyPipes, ThatWouldBeReadTwice) {
  const Workplace place;
  ASSERT_EQ(::mkfifo(place.path("log.csv").c_str(), 0600), 0);
  const Outcome outcome = place.run(
      {"identify", "log.csv", "--rig", in_repository("specs/log/bench_rig.json"), "--actuator",
       in_repository("specs/log/bench_actuator.json"), "--refined", "r.json"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err,
            "log.csv: is no plain file, and for a refined actuator it is read twice; write it "
            "into a file first\n");
}

// Each by itself would be waited for, longer than a run is given in all.
TEST(NastyPipes, AreWaitedForTogether) {
  const Workplace place;
  fs::create_directory(place.path("candidates"));
  fs::copy(kWholeKnee, place.path("candidates/knee.json"));
  for (int i = 0; i < 40; ++i) {
    const std::string pipe = "candidates/pipe" + std::to_string(i) + ".json";
    ASSERT_EQ(::mkfifo(place.path(pipe).c_str(), 0600), 0);
  }
  EXPECT_TRUE(place.run({"hopper", "check", kWholeRobot, kWholeSquat, "--candidates", "candidates"})
                  .has_ended);
}

TEST(NastyPipes, AmongCandidatesAreLeftOutAndSaid) {
  const Workplace place;
  fs::create_directory(place.path("candidates"));
  fs::copy(kWholeKnee, place.path("candidates/knee.json"));
  const Words command{"hopper",       "check",      kWholeRobot, kWholeSquat,
                      "--candidates", "candidates", "--ratios",  "8:9"};
  const Outcome without = place.run(command);
  ASSERT_EQ(::mkfifo(place.path("candidates/pipe.json").c_str(), 0600), 0);
  const Outcome beside = place.run(command);
  EXPECT_EQ(beside.exit_code, without.exit_code);
  EXPECT_EQ(beside.out, without.out +
                            "not tried: pipe: is a named pipe, and nobody wrote into it within 5 s"
                            "\n");
}

TEST(NastyPipes, ThatNobodyReads) {
  expect_refused(
      {
          {"actuator", "mor", kWholeKnee, "--plot", "pipe.svg"},
          {"actuator", "mor", kWholeKnee, "-o", "pipe"},
          {"hopper", "check", kWholeRobot, kWholeSquat, "--figures", "pipe.svg", "-o",
           "report.txt"},
          {"hopper", "check", kWholeRobot, kWholeSquat, "--sweep", "mass=12", "--jobs", "1",
           "--plot-sweep", "pipe.svg"},
          {"gearbox", "evaluate", in_repository("specs/gearbox/d151_knee.json").string(), "--teeth",
           "24,48,28", "--draw", "pipe.svg"},
      },
      "it is a named pipe, and nobody read from it within 5 s");
}

// Oracle: the picture in a file.
TEST(NastyPipes, ThatSomebodyReadsHoldThePicture) {
  const Workplace place;
  const Words command{"actuator", "mor", kWholeKnee, "--at-speed", "0", "--plot"};
  Words to_file = command, to_pipe = command;
  to_file.emplace_back("file.svg");
  to_pipe.emplace_back("pipe.svg");
  ASSERT_EQ(place.run(to_file).exit_code, 0);
  ASSERT_EQ(::mkfifo(place.path("pipe.svg").c_str(), 0600), 0);
  std::string got;
  Outcome outcome;
  {
    const std::jthread reader([&] { got = text_of(place.path("pipe.svg")); });
    outcome = place.run(to_pipe);
    // So that the reader ends even where nothing came.
    const std::string none = outcome.exit_code == 0 ? "" : "nothing";
    if (!none.empty()) place.write("pipe.svg", none);
  }
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(got, place.text("file.svg"));
}

}  // namespace
}  // namespace torquewright::cli_test
