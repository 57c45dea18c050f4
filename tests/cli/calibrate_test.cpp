// SPDX-License-Identifier: Apache-2.0
// `hopper calibrate` as a user runs it: exit codes, the files it writes, and what it refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/documents/schema.hpp"
#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;
using Words = std::vector<std::string>;

const std::string kThigh = "/bodies/0/inertia_kg_m2/yy,/bodies/0/inertia_kg_m2/xx";

/// A copy of the examples, where files may be written.
class Calibrate : public ::testing::Test {
 protected:
  Calibrate() {
    fs::copy(in_repository("specs"), place_.path("specs"), fs::copy_options::recursive);
  }

  Outcome calibrate(const Words& options) const {
    Words command{"hopper", "calibrate", "specs/robot/hopper.json"};
    command.insert(command.end(), options.begin(), options.end());
    return place_.run(command);
  }
  Outcome with_figures(Words options) const {
    options.insert(options.begin(), {"--target", "cam=6.0", "--target", "cav=7.4:10.6"});
    return calibrate(options);
  }
  Workplace place_;
};

TEST_F(Calibrate, MeetsThePublishedFiguresByAValley) {
  const Words free{"--free", kThigh + "=0.05:0.45", "--free", "/postures/takeoff/knee",
                   "--free", "/postures/tuck/knee"};
  Words options = free;
  options.insert(options.end(), {"--json", "--refined", "fitted.json"});
  const Outcome outcome = with_figures(options);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  const json report = json::parse(outcome.out);
  EXPECT_TRUE(io::conforms(report, "calibration_report"));
  EXPECT_EQ(report["verdict"], "valley");
  EXPECT_EQ(with_figures(free).out.find("one-legged hopper: met within 1 %, but by a valley"), 0u);

  // The robot that was written is one, says what was fitted, and meets the figures as it stands.
  const json fitted = json::parse(place_.text("fitted.json"));
  EXPECT_EQ(fitted["bodies"][0]["inertia_kg_m2"]["yy"], report["free"][0]["fitted"]);
  EXPECT_EQ(fitted["bodies"][0]["inertia_kg_m2"]["xx"], report["free"][0]["fitted"]);
  const std::vector<std::string> assumed = fitted["assumed"];
  EXPECT_EQ(std::count(assumed.begin(), assumed.end(), "/bodies/0/inertia_kg_m2/yy"), 1);
  EXPECT_EQ(fitted["provenance"].size(), 6u);
  const Outcome again =
      place_.run({"hopper", "calibrate", "fitted.json", "--target", "cam=6", "--target",
                  "cav=7.4:10.6", "--free", "/postures/tuck/knee", "--tolerance", "0.001"});
  EXPECT_EQ(again.exit_code, 0) << again.out << again.err;
}

TEST_F(Calibrate, FailsWhereTheFiguresCannotBeMet) {
  // A thigh alone moves both inertias alike: 0.81 - 0.566 is what the postures make of it.
  const Outcome outcome =
      calibrate({"--target", "cam=6", "--target", "cav=7.4:20", "--free", kThigh + "=0.05:0.45"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("not met: the best is off by"), std::string::npos) << outcome.out;
}

TEST_F(Calibrate, TakesPosturesFromTheCommandLine) {
  const Outcome outcome = calibrate({"--target", "cam=6", "--target", "cav@stretched=6",
                                     "--posture", "stretched=knee:0.1,ankle_pitch:0.3", "--free",
                                     kThigh + "=0.05:0.45", "--tolerance", "0.005", "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const json report = json::parse(outcome.out);
  EXPECT_EQ(report["verdict"], "determined");
  EXPECT_EQ(report["targets"][0]["posture"], "stretched");
}

TEST_F(Calibrate, DrawsTheValley) {
  const Outcome outcome =
      with_figures({"--free", kThigh + "=0.05:0.45", "--free", "/postures/takeoff/knee", "--free",
                    "/postures/tuck/knee", "--plot", "valley.svg"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(place_.text("valley.svg").find("</svg>"), std::string::npos);
}

TEST_F(Calibrate, RefusesWhatDoesNotRead) {
  const Words free{"--free", "/postures/tuck/knee"};
  const auto refusal = [&](Words options) {
    options.insert(options.end(), free.begin(), free.end());
    const Outcome outcome = calibrate(options);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    return outcome.err;
  };
  EXPECT_EQ(
      refusal({"--target", "cav=7.4:10.6"}),
      "--target: states no CAM (angular momentum about the centre of mass): cam=N in N m s\n");
  EXPECT_EQ(refusal({"--target", "cam=6"}),
            "--target: states no CAV (mean angular velocity): cav=N:N or cav@POSTURE=N in rad/s\n");
  EXPECT_EQ(refusal({"--target", "cam=6", "--target", "cam=6"}), "--target: CAM is given twice\n");
  EXPECT_NE(refusal({"--target", "cam=-6"}).find("must be from"), std::string::npos);
  EXPECT_NE(refusal({"--target", "cam=nan"}).find("must be cam=N"), std::string::npos);
  EXPECT_NE(refusal({"--target", "speed=6"}).find("must be cam=N"), std::string::npos);
  EXPECT_NE(refusal({"--target", "cam=6", "--target", "cav@nowhere=3"})
                .find("the robot has no posture \"nowhere\" (it has: stand, takeoff, tuck)"),
            std::string::npos);
  EXPECT_NE(refusal({"--target", "cam=6", "--target", "cav=7:10", "--posture", "x"})
                .find("must be NAME="),
            std::string::npos);
  EXPECT_NE(refusal({"--target", "cam=6", "--target", "cav=7:10", "--free", "/postures/tuck/knee"})
                .find("stands twice"),
            std::string::npos);
  EXPECT_EQ(refusal({"--target", "cam=6", "--target", "cav=7:10", "--posture", "stand=knee:1"}),
            "--posture: no --target is at \"stand\"; cav@stand=N states one\n");
  EXPECT_EQ(refusal({"--target", "cam=6", "--target", "cav=7:10", "--posture", "tuck=knee:1",
                     "--posture", "tuck=knee:2"}),
            "--posture: \"tuck\" is given twice\n");
  EXPECT_EQ(
      refusal({"--target", "cam=6", "--target", "cav=7:10", "--posture", "tuck=knee:1,knee:2"}),
      "--posture: \"knee\" is given twice\n");
  EXPECT_NE(refusal({"--target", "cam=6", "--target", "cav=7:10", "--posture", "tuck=kne:1"})
                .find("\"knee\""),
            std::string::npos);
}

}  // namespace
}  // namespace torquewright::cli_test
